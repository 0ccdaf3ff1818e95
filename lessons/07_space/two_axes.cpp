// Step 7: friction in space has two axes, and one bound.

#include "lessons/07_space/pucks.hpp"
#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "solver/system.hpp"

namespace byhand::space {
namespace {

constexpr int pucks = 24;

//! [disc]
/// Friction's two impulses within the disc of this radius: both are scaled by the same factor.
Eigen::Vector2d on_the_disc(const Eigen::Vector2d& lambda, double radius) {
  const double length = lambda.norm();
  return length > radius ? Eigen::Vector2d(radius / length * lambda) : lambda;
}
//! [disc]

/// Its largest distance from the solver's own bound, for impulses in and out of the disc.
double difference_from_the_solver(double mu) {
  double largest = 0;
  for (int i = 0; i < 100; ++i) {
    const Eigen::Vector2d lambda = 0.04 * i * Eigen::Vector2d(std::cos(i), std::sin(i));
    largest =
        std::max(largest, (bounded<2, Bound::friction>(lambda, 0, mu, 2) - on_the_disc(lambda, 2 * mu)).norm());
  }
  return largest;
}

/// By how much an impulse of friction is off, where the solver's t₁ and t₂ jump: with its old numbers, and with
/// those along the new axes [rad].
struct Jump {
  double kept, turned;
};
Jump over_the_jump() {
  const auto tangents = [](double x) {
    return Eigen::Matrix<double, 3, 2>(tangents_of<SpaceBody>({x, std::sqrt(1 - x * x), 0}));
  };
  const auto before = tangents(0.6 - 1e-12), after = tangents(0.6 + 1e-12);
  const Eigen::Vector2d lambda(2, 1);
  const Eigen::Vector3d impulse = before * lambda;
  const auto off = [&](const Eigen::Vector3d& found) {
    return std::atan2(found.cross(impulse).norm(), found.dot(impulse));
  };
  return {off(after * lambda), off(after * (after.transpose() * impulse))};
}

/// Pucks pushed off in all directions.
std::vector<double> all_round() {
  std::vector<double> headings;
  for (int i = 0; i < pucks; ++i) headings.push_back(2 * pi * i / pucks);
  return headings;
}

/// What the film shows: the ways of all pucks under either bound.
struct PucksFilm {
  std::vector<Way> pyramid, disc;
  double h, reach, friction;

  void draw_ways(Canvas& canvas, const std::vector<Way>& ways, const std::string& name, const Rectangle& frame,
                 double time) const {
    const Rectangle below{frame.x, frame.y, frame.width, frame.height - 40};
    Space space(pictures::from_aside({0, 0, 0}, 1.12 * reach, below, 0.35, 0.75));
    space.ground({0, 0, 0}, 1.9 * reach, reach / 2);
    const double size = 0.045 * reach;
    const auto last = static_cast<std::size_t>(std::floor(time / h + 1e-6));
    for (const Way& way : ways) {
      const std::size_t end = std::min(last, way.size() - 1), every = std::max<std::size_t>(1, end / 10);
      const auto place = [&](std::size_t i) { return Point3(way[i].x(), 0.5 * size, way[i].y()); };
      std::vector<Point3> trail;
      for (std::size_t i = 0; i < end; i += every) trail.emplace_back(way[i].x(), 0.01 * reach, way[i].y());
      trail.emplace_back(way[end].x(), 0.01 * reach, way[end].y());
      pictures::add_trail(space, trail, 0.02 * reach, palette::velocity);
      space.box(place(end), {2 * size, size, 2 * size}, Eigen::Quaterniond::Identity(), palette::highlight);
    }
    struct Axis {
      Point3 tip;
      const char* name;
    };
    const double raised = 0.02 * reach, axis = 0.38 * reach;
    const std::array<Axis, 2> axes{{{{axis, raised, 0}, "t_1"}, {{0, raised, axis}, "t_2"}}};
    for (const Axis& of : axes) space.arrow({0, raised, 0}, of.tip, 0.012 * reach, palette::constraint);
    canvas.draw(space);
    for (const Axis& of : axes) {
      const Point tip = space.project(of.tip);
      canvas.text(tip + 16 * (tip - space.project({0, raised, 0})).normalized(), of.name,
                  {.size = 20, .colour = palette::constraint, .halo = 3});
    }
    canvas.text({frame.centre().x(), frame.top() - 16}, name, {.size = 22, .bold = true});
  }

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(14).panels(0.5, 10);
    draw_ways(canvas, pyramid, "each axis by itself", left, time);
    draw_ways(canvas, disc, "both together: a disc", right, time);
    canvas.text({left.x + 8, left.y + 14}, say("@ s", Value(std::floor(time * 10 + 1e-9) / 10, 3)),
                {.size = 24, .anchor = Anchor::left, .bold = true});
  }
};

Chart stopped_at(const PucksFilm& film, double disc) {
  Chart chart{.x = {.label = "x (m)", .range = {{-1.17 * disc, 1.17 * disc}}},
              .y = {.label = "z (m)", .range = {{-0.06 * disc, 1.14 * disc}}}};
  Curve square{.label = "each axis", .style = CurveStyle::markers},
      circle{.label = "disc", .style = CurveStyle::markers},
      straight{.label = "square and circle of v²/2μg", .style = CurveStyle::theory},
      round{.style = CurveStyle::theory};
  for (int i = 0; i <= pucks / 2; ++i) {
    square.x.push_back(film.pyramid[i].back().x());
    square.y.push_back(film.pyramid[i].back().y());
    circle.x.push_back(film.disc[i].back().x());
    circle.y.push_back(film.disc[i].back().y());
  }
  straight.x = {-disc, 0, disc};
  straight.y = {0, disc, 0};
  for (int i = 0; i <= 120; ++i) {
    round.x.push_back(disc * std::cos(i * pi / 120));
    round.y.push_back(disc * std::sin(i * pi / 120));
  }
  chart.curves = {square, circle, straight, round};
  return chart;
}

}  // namespace

void two_axes(const Setting& setting, Page& page) {
  const double h = setting.h, v = setting.speed, a = setting.friction * gravity,
               heading = radians(setting.heading);
  const auto distance = [&](double angle, Bounds bounds, double turned = 0) {
    return slide(setting, {angle}, bounds, turned)[0].back().norm();
  };
  const double disc = distance(pi / 4, Bounds::disc), pyramid = distance(pi / 4, Bounds::pyramid);
  const Eigen::Vector2d closely = slide(setting, {heading}, Bounds::pyramid)[0].back();
  const Jump jump = over_the_jump();
  const double final_heading = std::atan2(closely.y(), closely.x());

  page.text(
      R"(At (16) the article says that friction has one axis in the plane and two in space. So a contact in space has two
      rows of (16), along t₁ and t₂ at right angles:)");
  page.equation(16);
  page.text(
      R"(Their bound is μ times the λ of the normal row (lesson 5). For one row that is an interval. The obvious way is to
      bound each of the two rows by itself. That bounds the impulse by a square (with the normal, a pyramid):)");
  page.excerpt("lessons/07_space/pucks.cpp", "pyramid");
  page.predict(
      {.ask = say(
           R"(Two pucks are pushed off at @ m/s, μ = @. One slides along t₁, the other at 45° between t₁ and t₂. How
                  far does the second get, as a share of the first one's distance?)",
           setting.speed, setting.friction),
       .answer = pyramid / disc,
       .unit = "1",
       .tolerance = 0.03,
       .wrong = {{1, "That would be so if friction did not depend on direction. Bounded axis by axis it does."},
                 {0.5, "Both rows brake fully, but at right angles: together √2 times as much, not twice."}},
       .hints = {"Each row brakes with all of μmg. How long is the sum of the two?", "v² = 2 a s, with a = √2 μg",
                 "s₂/s₁ = a₁/a₂: 1/√2 = …"},
       .right = say("1/√2 = @ for short steps; with steps of @ s it is @.", 1 / std::sqrt(2.0), setting.h,
                    Value(pyramid / disc, 3))});
  const std::vector<double> headings = all_round();
  const PucksFilm film{slide(setting, headings, Bounds::pyramid), slide(setting, headings, Bounds::disc), h,
                       v * v / (2 * a), setting.friction};
  page.sequence(
      "pyramid_and_disc",
      say(R"(@ pucks pushed off in all directions at @ m/s. Left: each axis bounded by itself. Right: both impulses
                    scaled together, so that no direction is special.)",
          pucks, setting.speed),
      Seconds{std::min(2.5, 1.15 * v / a)}, [film](Canvas& canvas, double time) { film.draw(canvas, time); });
  page.text(
      R"(Bounding each axis by itself is wrong in two ways. Between the axes friction is too strong, by up to √2. And v₁
      reaches zero after v₁/μg, v₂ after v₂/μg, so the path *bends*.@ For short steps, a puck
      that starts at the angle φ stops in the direction)",
      setting.heading == 45 ? " (Only at 0°, 45° and 90° it does not.)" : "");
  page.formula("tan φ' = tan² φ:  from @° to @°", R"(\tan\varphi' = \tan^2\varphi: \quad @^\circ \to @^\circ)",
               setting.heading, Value(degrees(std::atan(std::pow(std::tan(heading), 2))), 4));
  page.derivation("Why tan φ' = tan² φ",
                  {{"each axis brakes with all of μg", "s₁ = (v cosφ)²/2μg,   s₂ = (v sinφ)²/2μg",
                    R"(s_1 = \frac{(v\cos\varphi)^2}{2\mu g}, \quad s_2 = \frac{(v\sin\varphi)^2}{2\mu g})"},
                   {"the direction of its stopping point", "tan φ' = s₂/s₁ = tan² φ",
                    R"(\tan\varphi' = \frac{s_2}{s_1} = \tan^2\varphi)"},
                   {"all stopping points", "s₁ + s₂ = v²/2μg: a square, not a circle",
                    R"(s_1 + s_2 = \frac{v^2}{2\mu g}: \text{ a square, not a circle})"}});
  page.text(
      R"(And the solver chooses the axes: turn t₁ and t₂ by 45°, and other pucks get farthest. Coulomb's law has one
      bound, for the length of the impulse. So the two rows are one block, solved together and scaled together. (t₁
      and t₂ may turn from step to step; the remembered impulse stays, so a warm start needs its numbers in the new
      axes. With its old numbers it would be @° off where n passes (0.6, 0.8, 0) and the solver's axes jump.))",
      Value(degrees(jump.kept), 3));
  page.excerpt("lessons/07_space/two_axes.cpp", "disc");
  page.figure("where_they_stop",
              "Where half of the pucks stop, from above. Dashed, for very short steps: a square with each axis by "
              "itself, a circle with the disc.",
              stopped_at(film, v * v / (2 * a)));
  page.measure("distance at 45°, each axis over disc", pyramid / disc, "1");
  // A slow axis may stop within its first step.
  page.measure("heading at the end, each axis", std::abs(final_heading) < 1e-9 ? 0 : degrees(final_heading),
               "deg");

  const auto stop = [&](double share) { return stopping_distance(share * v, a, h); };
  const double root = std::sqrt(0.5), within = 1e-9 * v * v / a;
  page.claim("distance at 45°, each axis over disc", pyramid / disc, "1",
             is(std::sqrt(2.0) * stop(root) / stop(1), "√2·s(v/√2)/s(v), s summed step by step", relative(1e-8)));
  page.claim(say("where the puck at @° stops, each axis: x", setting.heading), closely.x(), "m",
             is(stop(std::cos(heading)), "one axis by itself", absolute(within)));
  page.claim("the same, z", closely.y(), "m", is(stop(std::sin(heading)), "one axis by itself", absolute(within)));
  page.claim("the puck at 45°, each axis, both axes turned by 45°", distance(pi / 4, Bounds::pyramid, pi / 4), "m",
             is(stop(1), "now it goes along one axis", absolute(within)));
  double nearest = INFINITY, farthest = 0;
  for (const Way& way : film.disc) {
    nearest = std::min(nearest, way.back().norm());
    farthest = std::max(farthest, way.back().norm());
  }
  page.claim("disc: nearest of all directions", nearest, "m", is(stop(1), "the plane's", absolute(within)));
  page.claim("disc: farthest of all directions", farthest, "m", is(stop(1), "the plane's", absolute(within)));
  page.claim("plain bound of the disc from the solver's", difference_from_the_solver(setting.friction), "1",
             is(0, "bounded", absolute(1e-12)));
  page.claim("remembered impulse in the new axes: off by", jump.turned, "rad",
             is(0, "TᵀT₀λ₀, T the new t₁ and t₂", absolute(1e-9)));
}

}  // namespace byhand::space
