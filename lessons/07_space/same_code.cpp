// Step 1: what three dimensions change in the code, and what they do not.

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::space {
namespace {

constexpr double rod_seconds = 2;

/// How many numbers a model's state and rows take.
struct Numbers {
  double row, velocity, pose, inertia;
};
template <class T>
constexpr int doubles_in = sizeof(T) / sizeof(double);
template <class M>
Numbers numbers_of() {
  int orientation = 0;
  if constexpr (M::angular > 0) orientation = doubles_in<Rotation<M>>;
  return {doubles_in<Jacobian<M, 1>>, Velocity<M>::SizeAtCompileTime, static_cast<double>(M::linear + orientation),
          M::angular};
}

Chart how_many() {
  const std::array<Numbers, 4> models{numbers_of<PlaneParticle>(), numbers_of<PlaneBody>(),
                                      numbers_of<SpaceParticle>(), numbers_of<SpaceBody>()};
  Chart chart{.y = {.label = "numbers"},
              .bar_names = {"plane particle", "plane body", "space particle", "space body"}};
  const auto bars = [&](const char* label, double Numbers::*count) {
    Bars result{.label = label};
    for (const Numbers& model : models) result.values.push_back(model.*count);
    chart.bars.push_back(std::move(result));
  };
  bars("a row of J", &Numbers::row);
  bars("pose", &Numbers::pose);
  bars("V", &Numbers::velocity);
  bars("I", &Numbers::inertia);
  return chart;
}

/// One line for all models.
template <class M>
Simulation<M> swinging(const Setting& setting) {
  return {hinged_rod<M>(radians(setting.angle), setting.length, setting.mass), {Direct{}, Baumgarte{0.2}}};
}

/// The same rod in the plane and in space, every tenth of a second.
struct Twins {
  std::vector<Point> plane;   // centres [m]
  std::vector<Point3> space;  // centres [m]
  double apart = 0;           // the largest distance between the two in any step [m]
};
Twins twins(const Setting& setting) {
  auto plane = swinging<PlaneBody>(setting);
  auto space = swinging<SpaceBody>(setting);
  const double h = setting.h;
  Twins twins;
  const auto every = std::max(1L, std::lround(0.1 / h));
  for (long i = 0; i * h <= rod_seconds; ++i) {
    const Point x = plane.scene.bodies().pose[1].position;
    const Point3 y = space.scene.bodies().pose[1].position;
    twins.apart = std::max(twins.apart, (Point3(x.x(), x.y(), 0) - y).norm());
    if (i % every == 0 && i * h < 0.75) {
      twins.plane.push_back(x);
      twins.space.push_back(y);
    }
    plane.step(h);
    space.step(h);
  }
  return twins;
}

void draw_twins(Canvas& canvas, const Twins& twins, double length) {
  const auto [left, right] = canvas.page().inset(24).panels(0.5, 24);
  // All rods, and the floor as far as at the defaults.
  double low = -0.8 * length, high = 1.05 * length;
  for (const Point& centre : twins.plane) {
    low = std::min(low, 2 * centre.x() - 0.1 * length);
    high = std::max(high, 2 * centre.x() + 0.1 * length);
  }
  const Rectangle under{left.x, left.y, left.width, left.height - 50};
  const auto age = [&](std::size_t i) {
    return static_cast<double>(i + 1) / static_cast<double>(twins.plane.size());
  };
  canvas.look(fit({low, -1.1 * length, high - low, 1.25 * length}, under, 10));
  for (std::size_t i = 0; i < twins.plane.size(); ++i)
    canvas.rod({0, 0}, 2 * twins.plane[i],
               {mix(palette::constraint, palette::paper, 0.85 * (1 - age(i))), {palette::ink, 0}}, 12);
  canvas.anchor({0, 0});
  canvas.look_at_page();
  Space space(pictures::from_aside({(low + high) / 2, -0.55 * length, 0}, 0.5 * (high - low),
                                   {right.x, right.y, right.width, under.height}));
  space.ground({0, -1.25 * length, 0}, 2.2 * length, 0.4 * length);
  for (std::size_t i = 0; i < twins.space.size(); ++i)
    space.rod({0, 0, 0}, 2 * twins.space[i], 0.025 * length,
              mix(palette::constraint, palette::paper, 0.85 * (1 - age(i))));
  space.sphere({0, 0, 0}, 0.05 * length, palette::fixed);
  canvas.draw(space);
  canvas.text({left.centre().x(), left.top() - 16}, "hinged\\_rod<PlaneBody>", {.size = 21, .bold = true});
  canvas.text({right.centre().x(), right.top() - 16}, "hinged\\_rod<SpaceBody>", {.size = 21, .bold = true});
}

}  // namespace

void same_code(const Setting& setting, Page& page) {
  const Numbers plane = numbers_of<PlaneBody>(), space = numbers_of<SpaceBody>();
  page.text(
      R"(Here are the row of lesson 1 as the solver writes it, and the product (8) that each sweep needs, in plane and
      space. Look for a 2 or a 3 that stands for the number of dimensions:)");
  page.excerpt("solver/jacobian.hpp", "along");
  page.excerpt("solver/jacobian.hpp", "8");
  page.text(
      R"(There is none. A body's type says along how many axes it moves and about how many it turns: bodies in the plane
      are `Model<2, 1>`, bodies in this lesson `Model<3, 3>`, and no code is written twice. Five things change:

      - r × n is one number in the plane (how much a push turns the body) and three in space (about which axis);
      - I is one number in the plane; in space it is three, along axes that turn with the body (step 2);
      - an orientation is a cosine and a sine in the plane and a quaternion in space (step 7a);
      - Iω and ω may point in different directions, and then ω turns without any force (step 5);
      - friction has one axis in the plane and two in space (step 7).)");
  page.figure("numbers",
              R"(Numbers in a row of J (both bodies) and in a body's pose, velocity and inertia, by model.)",
              how_many());
  page.text(
      R"(A row has @ numbers instead of @, and a body's velocity @ instead of @, so a row costs twice as many
      multiplications in a sweep. Nothing else changes for sweeps and β: they only see rows.)",
      space.row, plane.row, space.velocity, plane.velocity);
  const double growth = 3 * space.row / (2 * plane.row);
  page.predict(
      {.ask =
           R"(A contact with friction has two rows in the plane and three in space. By what factor does the number of
                 multiplications in its JV grow?)",
       .answer = growth,
       .unit = "1",
       .tolerance = 0.1,
       .wrong = {{2, "That is one row. There are also more rows."},
                 {1.5, "That is the number of rows. Each is also longer."}},
       .hints = {"How many rows does it have, and how many numbers has each?",
                 say("2 · @ in the plane, 3 · @ in space.", plane.row, space.row)},
       .hinted = growth,
       .right = say("3 · @ over 2 · @.", space.row, plane.row)});

  const Twins pair = twins(setting);
  page.text(
      R"(To check that, let the same rod swing in both models: `hinged_rod<M>`, @ m long, @ kg, released at @°, held by
      two rows in the plane and by three in space.)",
      setting.length, setting.mass, setting.angle);
  page.figure(
      "twins",
      R"(One scene in two models: a rod swings on a pin in the plane and on a ball joint in space; a tenth of a
              second from one position to the next.)",
      [=, length = setting.length](Canvas& canvas) { draw_twins(canvas, pair, length); });

  page.claim("numbers in a row", space.row, "1", is(2 * (3 + 3), "(6): l1 a1 l2 a2, three each", absolute(0)));
  page.claim(say("rod in space from rod in the plane, over @ s", rod_seconds), pair.apart, "m",
             is(0, "the same rod <2,1>", absolute(1e-10 * setting.length)));
}

}  // namespace byhand::space
