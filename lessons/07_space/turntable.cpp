// Deeper: boxes on a turntable, a body that is driven.

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::space {
namespace {

constexpr double ride_seconds = 2, turning = 2;  // [s], [rad/s]

/// Flat boxes that at first turn with a disc, and how far each is from its axis.
struct Turntable {
  double h, limit;  // [s], [m]
  Eigen::Vector3d sides;
  Simulation<SpaceBody> boxes{{}, {GaussSeidel{.sweeps = 100, .tolerance = 1e-12}, Baumgarte{.slop = 1e-3}}};

  /// `shares` of the radius μg/ω².
  Turntable(const Setting& setting, const std::vector<double>& shares)
      : h(setting.h), limit(setting.friction * gravity / (turning * turning)), sides(0.2, 0.02, 0.2) {
    sides *= limit;
    Scene<SpaceBody>& scene = boxes.scene;
    const Surface surface{.friction = setting.friction};
    //! [driven]
    Velocity<SpaceBody> spin;
    spin << 0, 0, 0, 0, turning, 0;
    const int disc = scene.add_body(Linear<SpaceBody>(0, 0, 0), fixed<SpaceBody>(), spin);
    scene.set_shape(disc, HalfSpace<SpaceBody>{{0, 1, 0}}, surface);
    //! [driven]
    for (std::size_t i = 0; i < shares.size(); ++i) {
      const double angle = 2 * pi * static_cast<double>(i) / static_cast<double>(shares.size());
      Pose<SpaceBody> pose;
      pose.rotation = space_rotation(Angular<SpaceBody>(0, angle, 0));
      pose.position = pose.rotation * Eigen::Vector3d(shares[i] * limit, 0.5 * sides.y(), 0);
      const int box = add_box(scene, pose, setting.mass, Linear<SpaceBody>(sides), surface);
      Velocity<SpaceBody> V = spin;
      V.head<3>() = Eigen::Vector3d(0, turning, 0).cross(pose.position);
      scene.set_velocity(box, V);
    }
  }

  void go_on(double time) {
    while (boxes.time < time - 0.5 * h) boxes.step(h);
  }
  double radius(int box) const {
    const auto& at = boxes.scene.bodies().pose[box].position;
    return std::hypot(at.x(), at.z());
  }
};

/// How fast a box slips on the disc in its third step, in units of μgh. In the first no force is needed.
double slip(const Setting& setting, double share) {
  Turntable table(setting, {share});
  const Bodies<SpaceBody>& bodies = table.boxes.scene.bodies();
  table.go_on(2 * table.h);
  const Eigen::Vector3d at = bodies.pose[1].position;
  table.boxes.step(table.h);
  const Eigen::Vector3d slips = bodies.velocity[1].head<3>() - Eigen::Vector3d(0, turning, 0).cross(at);
  return std::hypot(slips.x(), slips.z()) / (setting.friction * gravity * table.h);
}

/// The radius [m] from which a box slips, by bisection.
double measured_limit(const Setting& setting) {
  double sticks = 0.5, slips = 2;
  for (int i = 0; i < 12; ++i) {
    const double middle = (sticks + slips) / 2;
    (slip(setting, middle) > 0.005 ? slips : sticks) = middle;
  }
  return (sticks + slips) / 2 * Turntable(setting, {}).limit;
}

Chart radii_over_time(Turntable table, const std::vector<double>& shares) {
  Chart chart{.x = {.label = "time (s)", .range = {{0, ride_seconds}}},
              .y = {.label = "distance from the axis/limit", .range = {{0, 2.7}}}};
  for (const double share : shares) chart.curves.push_back({.label = say("from @", share)});
  for (; table.boxes.time < ride_seconds + 0.5 * table.h; table.boxes.step(table.h))
    for (std::size_t i = 0; i < shares.size(); ++i) {
      chart.curves[i].x.push_back(table.boxes.time);
      chart.curves[i].y.push_back(table.radius(static_cast<int>(i) + 1) / table.limit);
    }
  chart.references.push_back({.value = 1, .label = "limit"});
  return chart;
}

void draw(Canvas& canvas, const Turntable& table, const Rectangle& frame) {
  const double rim = 2.6 * table.limit, line = 0.012 * table.limit;
  Space space(pictures::from_aside({0, 0, 0}, 1.05 * rim, frame, 0.35, 0.75));
  space.ground({0, -0.02 * table.limit, 0}, 1.9 * rim, rim);
  pictures::add_ring(space, {0, 0, 0}, {0, 1, 0}, rim, 2 * line, palette::muted);
  pictures::add_ring(space, {0, 0, 0}, {0, 1, 0}, table.limit, 2 * line, palette::constraint);
  const auto& pose = table.boxes.scene.bodies().pose;
  for (int i = 0; i < 12; ++i) {
    const Eigen::Vector3d spoke =
        rotate(pose[0].rotation, Eigen::Vector3d(std::cos(i * pi / 6), 0, std::sin(i * pi / 6)));
    space.rod({0, 0, 0}, rim * spoke, line, palette::muted);
  }
  for (std::size_t i = 1; i < pose.size(); ++i)
    space.box(pose[i].position, table.sides, pose[i].rotation, palette::series(static_cast<int>(i) - 1));
  canvas.draw(space);
}

}  // namespace

void turntable(const Setting& setting, Page& page) {
  const std::vector<double> shares{0.5, 0.9, 1.1};
  const Turntable table(setting, shares);
  const double limit = table.limit, h = setting.h;
  page.text("A turntable is driven, as the lift of lesson 5 is: its M⁻¹ is 0, and it has an ω of its own.");
  page.excerpt("lessons/07_space/turntable.cpp", "driven");
  const double found = measured_limit(setting);
  page.predict(
      {.ask =
           say(R"(The disc turns at ω = @ rad/s, μ = @, and a box of @ kg turns with it. Up to which distance from
                  the axis does friction hold the box?)",
               turning, setting.friction, setting.mass),
       .answer = found,
       .unit = "m",
       .tolerance = 0.03 * limit,
       .wrong = {{gravity / (turning * turning), "That is for μ = 1."},
                 {setting.mass * limit, "Both forces are proportional to the mass: it cancels."}},
       .hints = {"Which force does a circle take, and who gives it?", "mω²r ≤ μmg.",
                 say("@ · @/@² m = …", setting.friction, gravity, turning)},
       .right = "μg/ω²: the two rows of friction give mω²rh in a step, and at most μmgh."});
  page.sequence(
      "turntable",
      say("Boxes on a disc that turns at @ rad/s. Ring: the limit. Right: how far each is from the axis.",
          turning),
      Seconds{ride_seconds},
      [table = table, radii = radii_over_time(table, shares)](Canvas& canvas, double time) mutable {
        const auto [left, right] = canvas.page().inset(14).panels(0.58, 16);
        table.go_on(time);
        draw(canvas, table, left);
        renderer::draw(canvas, pictures::grown_to(radii, table.boxes.time), right.lowered(50));
      });
  Turntable after = table;
  after.go_on(ride_seconds);
  const double steps = std::round(after.boxes.time / h),
               growth = std::pow(1 + turning * turning * h * h, steps / 2);
  const Quantity end("distance from the axis/(μg/ω²), from 0.9", after.radius(2) / limit);
  page.text(
      R"(No row knows of circles: the disc's velocity at the box turns, and JV = 0 turns with it. The bound must be the
      same in every direction: it is step 7's disc. And friction has no C. In each step a box moves along the tangent,
      so that even one that sticks creeps outwards, by the factor √(1 + ω²h²): by @ % in these @ s. @)",
      Value(100 * (growth - 1), 2), ride_seconds,
      page.verdict(
          {{.when = end < 1, .say = say("The box from @ of the limit still sticks then.", shares[1])},
           {.when = end >= 1,
            .say = say("That has brought the box from @ of the limit beyond it, where it slips.", shares[1]),
            .law = Quantity("0.9 (1 + ω²h²)^(n/2)", shares[1] * growth) > 0.99}}));
  page.claim("distance from which a box slips", found, "m", is(limit, "ω²r = μg", relative(0.02)));
  page.claim("slip at 0.95 of it, third step", slip(setting, 0.95), "μgh", is(0, "it sticks", absolute(1e-3)));
  constexpr double beyond = 1.05;
  page.claim("slip at 1.05 of it, third step", slip(setting, beyond), "μgh",
             is(2 * (beyond - 1), "(ω²r/μg − 1) a step, two steps", relative(0.1)));
  page.claim("creep of the box from 0.5, to the end", after.radius(1) / (shares[0] * limit), "1",
             is(growth, "√(1 + ω²h²) a step", relative(1e-6)));
}

}  // namespace byhand::space
