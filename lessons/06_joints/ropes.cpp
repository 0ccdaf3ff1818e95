// Deeper: a rod with one sign of λ missing.

#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/rope.hpp"

namespace byhand::joints {
namespace {

constexpr int finer = 16;  // steps for one of the lesson's: the moment of letting go is known to a step

/// Where a bob went and what held it.
struct Track {
  std::vector<double> time, pull;  // [s], [mg]
  std::vector<Point> path;
  double let_go = NAN;  // cos θ from straight down where it was first let go
};

Track track_of(Simulation<PlaneParticle> simulation, const Setting& setting, double seconds) {
  const double h = setting.h / finer, weight = setting.mass * gravity * h;
  Track track;
  advance_to(simulation, seconds, h, [&] {
    const Point at = simulation.scene.bodies().pose[1].position;
    const double lambda = simulation.impulse(0)[0];
    track.time.push_back(simulation.time);
    // The throw starts along the tangent, without drift; the first steps build it up.
    track.pull.push_back(simulation.time < 20 * h ? NAN : std::abs(lambda) / weight);
    track.path.push_back(at);
    if (std::isnan(track.let_go) && lambda == 0) track.let_go = -at.y() / at.norm();
  });
  return track;
}

/// A bob at the lowest point with the speed that would take it just to the top.
template <template <class> class Holder>
Simulation<PlaneParticle> thrown(const Setting& setting, double speed) {
  const double length = setting.length;
  Simulation<PlaneParticle> simulation{{}, {.solver = Direct{}, .drift = Baumgarte{setting.beta}}};
  auto& scene = simulation.scene;
  scene.add_body(Linear<PlaneParticle>(0, 0), fixed<PlaneParticle>());
  scene.add_body(Linear<PlaneParticle>(0, -length), with_mass<PlaneParticle>(setting.mass),
                 Linear<PlaneParticle>(speed, 0));
  scene.add(Holder<PlaneParticle>{{0, 1}, length});
  return simulation;
}

}  // namespace

void ropes(const Setting& setting, Page& page) {
  const double length = setting.length, speed = std::sqrt(4 * gravity * length),
               seconds = 4.6 * std::sqrt(length / gravity);
  const Track rope = track_of(thrown<Rope>(setting, speed), setting, seconds),
              rod = track_of(thrown<NormalisedDistance>(setting, speed), setting, seconds);
  page.text(
      R"(A rope is a rod that can only pull: the same J, and λ ≥ 0 for its tension. Take a bob of @ kg on @ m, at
      the lowest point, and throw it at √(4gL) = @ m/s. That is just enough for a rod to carry it to the top.)",
      setting.mass, setting.length, Value(speed, 3));
  page.predict({.ask = "At which angle from straight down does the rope go slack, in degrees?",
                .answer = degrees(std::acos(-2.0 / 3)),
                .unit = "°",
                .tolerance = 4,
                .wrong = {{180, "The bob would arrive there without speed, held up by the rope."},
                          {90, "There it is still fast: bending its path takes twice the weight."}},
                .hints = {"The rope's pull bends the path; above the anchor gravity helps, below it hinders.",
                          "T = m(v²/L + g cos θ), and v² = 4gL − 2gL(1 − cos θ).",
                          "T = mg(2 + 3 cos θ), and it goes slack where T = 0."},
                .hinted = degrees(std::acos(-2.0 / 3)),
                .right = say("The pull mg(2 + 3 cos θ) becomes zero where cos θ = −2/3, at @°; in this run at @°.",
                             Value(degrees(std::acos(-2.0 / 3)), 5), Value(degrees(std::acos(rope.let_go)), 5))});
  page.derivation("Where the pull ends", {{"energy, from the lowest point with v₀² = 4gL",
                                           "v² = 4gL − 2gL(1 − cos θ)", R"(v^2 = 4gL - 2gL\,(1-\cos\theta))"},
                                          {"along the rope: mass times v²/L towards the anchor",
                                           "T = m(v²/L + g cos θ)", R"(T = m\,(v^2/L + g\cos\theta))"},
                                          {"insert", "T = mg(2 + 3 cos θ)", R"(T = mg\,(2 + 3\cos\theta))"}});
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "pull or push, |λ|/h (mg)"}};
  chart.curves = {{.label = "rope", .x = rope.time, .y = rope.pull},
                  {.label = "rod", .x = rod.time, .y = rod.pull}};
  chart.y.range = {{0, 5.5}};
  for (Curve& curve : chart.curves)
    for (double& pull : curve.y)
      if (pull > 5.5) pull = NAN;
  page.sequence(
      "rope_and_rod",
      R"(The same throw on a rope and on a rod. On the rope the bob leaves the circle and flies a parabola until it is
      caught (that jerk is off the chart); the rod begins to push and keeps it on the circle.)",
      Seconds{seconds}, [=](Canvas& canvas, double time) {
        const auto [left, right] = canvas.page().inset(16).panels(0.5, 20);
        canvas.look(fit({-1.2 * length, -1.2 * length, 2.4 * length, 2.4 * length}, left, 10));
        std::vector<Point> circle;
        for (int i = 0; i <= 120; ++i)
          circle.emplace_back(length * std::cos(i * pi / 60), length * std::sin(i * pi / 60));
        canvas.path(circle, {palette::theory, 1.6, Dash::dashed});
        const auto now = [time](const Track& track) {
          const auto passed = std::upper_bound(track.time.begin(), track.time.end(), time) - track.time.begin();
          return std::vector<Point>(track.path.begin(), track.path.begin() + std::max<std::ptrdiff_t>(passed, 1));
        };
        const std::vector<Point> on_rope = now(rope), on_rod = now(rod);
        if (on_rod.size() > 1) canvas.path(on_rod, {palette::series(1), 3});
        if (on_rope.size() > 1) canvas.path(on_rope, {palette::series(0), 3});
        canvas.anchor({0, 0});
        const bool slack = on_rope.back().norm() < 0.999 * length;
        canvas.line({0, 0}, on_rope.back(), {palette::series(0), 2.4, slack ? Dash::dotted : Dash::solid});
        canvas.rod({0, 0}, on_rod.back(), {palette::series(1), {palette::ink, 0}}, 6);
        canvas.hinge({0, 0});
        for (const Point& bob : {on_rod.back(), on_rope.back()}) canvas.disc(bob, 0.07 * length);
        canvas.look_at_page();
        draw(canvas, pictures::grown_to(chart, time), right.lowered(60));
      });
  page.text(
      R"(The code has no case for taut or slack. While the rope is slack, the row lets the bob close the gap within the
      step and no more,
      JV ≥ −C/h. To keep it on the circle, (17) would need a λ that pushes; the clamp makes that zero, and the bob
      flies. When it would go beyond the rope's length, the same row catches it.)");
  page.claim("cos θ where the rope goes slack", rope.let_go, "1",
             is(-2.0 / 3, "mg(2 + 3 cos θ) = 0", absolute(8 * setting.h / finer / std::sqrt(length) + 1e-3)));
}

}  // namespace byhand::joints
