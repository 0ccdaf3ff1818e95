// Step 2: an overlap, and the speed at which it leaves.

#include <algorithm>
#include <cmath>

#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/scenes/boxes.hpp"
#include "solver/step.hpp"

namespace byhand::contact {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double pop_seconds = 1.5;

/// A unit box that begins `depth` [m] deep in the ground.
Simulation<PlaneBody> sunk(double depth, const Baumgarte& cure) {
  Simulation<PlaneBody> simulation{stack(1), {GaussSeidel{}, cure}};
  simulation.scene.state().pose[1].position.y() -= depth;
  return simulation;
}

/// How far its lower side is above the ground [m].
double clearance(const Simulation<PlaneBody>& simulation) {
  return simulation.scene.bodies().pose[1].position.y() - 0.5;
}

double peak(Simulation<PlaneBody> simulation, double h) {
  double highest = clearance(simulation);
  while (simulation.time < pop_seconds) {
    simulation.step(h);
    highest = std::max(highest, clearance(simulation));
  }
  return highest;
}

/// The depth from which it leaves the ground, law B2 [m].
double law_of_pop(double beta, double h) { return (1 - beta / 2) * 2 * gravity * h * h / (beta * beta); }

/// The speed at which that depth leaves: what is slower does not get off the ground [m/s].
double harmless_speed(double beta, double h) { return beta / h * law_of_pop(beta, h); }

double measured_pop(double beta, double h) {
  double stays = 0.5 * law_of_pop(beta, h), pops = 1.5 * law_of_pop(beta, h);
  for (int i = 0; i < 30; ++i) {
    const double middle = 0.5 * (stays + pops);
    (peak(sunk(middle, {beta}), h) > 1e-11 ? pops : stays) = middle;
  }
  return 0.5 * (stays + pops);
}

/// The peak of a throw at v = βd/h from where the first step ends, in steps of symplectic Euler [m].
double law_of_peak(double depth, double beta, double h) {
  const double v = beta * depth / h, n = std::floor(v / (gravity * h)) + 1;
  return -depth + h * (n * v - gravity * h * n * (n - 1) / 2);
}

struct NamedBox {
  std::string name;
  Simulation<PlaneBody> box;
};

/// Heights over time, one curve for each run.
Chart heights(const std::vector<NamedBox>& runs, double h) {
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "height of the lower side (m)"}};
  for (NamedBox run : runs) {
    Curve curve{.label = run.name, .x = {0}, .y = {clearance(run.box)}};
    while (run.box.time < pop_seconds) {
      run.box.step(h);
      curve.x.push_back(run.box.time);
      curve.y.push_back(clearance(run.box));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = 0, .label = "ground"});
  return chart;
}

void draw_runs(Canvas& canvas, const std::vector<NamedBox>& runs, const Rectangle& frame, double top) {
  const auto cells = frame.cells(1, static_cast<int>(runs.size()), 12);
  for (std::size_t i = 0; i < runs.size(); ++i) {
    const Rectangle below{cells[i].x, cells[i].y, cells[i].width, cells[i].height - 54};
    canvas.look_at_page();
    canvas.text({cells[i].centre().x(), cells[i].top() - 24}, runs[i].name,
                {.size = 20, .colour = palette::series(static_cast<int>(i)), .bold = true});
    canvas.clip(below);
    canvas.look(fit({-0.7, -0.5, 1.4, top + 0.6}, below, 0));
    pictures::draw(canvas, pictures::shapes_of(runs[i].box.scene));
    canvas.clip({});
  }
  canvas.look_at_page();
}

Chart peaks(const Setting& setting) {
  const double h = setting.h();
  Chart chart{.x = {.label = "overlap at the start (m)"}, .y = {.label = "peak above the ground (m)"}};
  for (const double beta : {0.5 * setting.beta(), setting.beta(), std::min(1.0, 2 * setting.beta())}) {
    const double limit = law_of_pop(beta, h);
    Curve measured{.label = say("β = @", Value(beta, 2)), .style = CurveStyle::markers},
        law{.style = CurveStyle::theory};
    for (int i = 1; i <= 20; ++i) {
      const double depth = 0.02 * i;
      measured.x.push_back(depth);
      measured.y.push_back(std::max(0.0, peak(sunk(depth, {beta}), h)));
      law.x.push_back(depth);
      law.y.push_back(depth > limit ? law_of_peak(depth, beta, h) : 0);
    }
    chart.curves.push_back(measured);
    chart.curves.push_back(law);
  }
  chart.curves.back().label = "a throw at βd/h";
  return chart;
}

}  // namespace

void deep_contact(const Setting& setting, Page& page) {
  const double h = setting.h(), beta = setting.beta(), depth = setting.depth(), cap = setting.cap();
  const double law = law_of_pop(beta, h), speed = beta * depth / h;
  Simulation<PlaneBody> first = sunk(depth, {beta});
  first.step(h);
  const double leaves_at = first.scene.bodies().velocity[1].y();

  page.text(
      R"(Where C is positive there is still room: the row lets the gap close within the step and no further, b =
      C/h. Where it is negative, two bodies are inside each other, and (22) has them out again by a share β a step,
      as it did with rods. But a rod is held on both sides. Nothing holds a box that comes out of the ground.)");
  page.equation(22, "JV = −(β/h)·C = −(@/(@ s))·(−@ m) = @ m/s",
                R"(JV = -\frac{\beta}{h}\,C = -\frac{@}{@\,\mathrm{s}}\cdot(-@\,\mathrm{m}) = @\,\mathrm{m/s})",
                setting.beta, setting.h, setting.depth, speed);
  page.predict(
      {.ask = say("A unit box begins @ m deep in the ground, at rest; β = @, h = @ s. How fast does it leave?",
                  setting.depth, setting.beta, setting.h),
       .answer = leaves_at,
       .unit = "m/s",
       .tolerance = 0.03 * speed,
       .wrong = {{0, "The row asks for a rate of −βC/h, and the ground may push as hard as that takes."},
                 {depth / h, "That would have all of it out in one step; β takes a share."}},
       .hints = {"β of the overlap is to be gone after one step of h."},
       .right = "Sunk by accident, thrown by a catapult."});
  const std::vector<NamedBox> runs{
      {say("@ m deep", Value(0.8 * law, 2)), sunk(0.8 * law, {beta})},
      {say("@ m deep", depth), sunk(depth, {beta})},
      {say("@ m, at most @ m/s", depth, cap), sunk(depth, {.beta = beta, .speed_cap = cap})}};
  const Chart chart = heights(runs, h);
  const double top = std::max(1.2, 1.1 + std::min(4.0, peak(runs[1].box, h)));
  page.sequence(
      "pop",
      say(R"(Three boxes come out of the ground, β = @: from @ of the limit, from @ m, and from there with a limit
          on the speed.)",
          setting.beta, 0.8, setting.depth),
      Seconds{pop_seconds}, [=, runs = runs](Canvas& canvas, double time) mutable {
        for (NamedBox& run : runs)
          while (run.box.time < time - 0.5 * h) run.box.step(h);
        const auto [left, right] = canvas.page().inset(16).split_columns(0.56, 20);
        draw_runs(canvas, runs, left, top);
        renderer::draw(canvas, pictures::grown_to(chart, time), right.inset(0, 60));
      });
  page.text(
      R"(Once in flight it is a stone that was thrown upwards at βd/h. In the first step it rises by βd; then
      gravity takes gh from its speed in every step. Sum that, and the highest point lies above the ground if)");
  page.formula("d > (1 − β/2) · 2gh²/β² = @ m",
               R"(d > \left(1-\tfrac{\beta}{2}\right)\frac{2 g h^2}{\beta^2} = @\,\mathrm{m})", law);
  page.figure(
      "pop_over_depth",
      say("How high a box pops above the ground against how deep it began, h = @ s. Lines: a throw at βd/h.",
          setting.h),
      peaks(setting));
  page.text(
      R"(Twice the β, a quarter of the depth: in a game that spawns things inside each other a large β is a gun.
      Three cures are in use. A *smaller* β. A *limit* on the speed that the correction may ask for: below @ m/s,
      at which the limiting depth leaves, whatever is stuck comes out and stays down. And *split impulses*, which
      solve the correction by itself and throw its velocity away once it has moved the box; they cost a second
      solve and are not in this solver. (The few millimetres of *slop* that engines leave alone are for another
      trouble: a contact at rest that is corrected to the last is open every other step, and has to be found
      anew.))",
      Value(harmless_speed(beta, h), 3));

  page.measure("peak above the ground", peak(sunk(depth, {beta}), h), "m");
  page.claim({.quantity = "speed at which it leaves",
              .unit = "m/s",
              .expected = speed,
              .source = "βd/h, (22)",
              .measured = leaves_at,
              .tolerance = relative(1e-12)});
  page.claim({.quantity = "depth from which it pops off the ground",
              .unit = "m",
              .expected = law,
              .source = "law B2: (1 − β/2)·2gh²/β²",
              .measured = measured_pop(beta, h),
              .tolerance = relative(1e-6),
              .claimed = law < 0.3 && beta < 0.5,
              .range = "a limit below 0.3 m, β < 0.5"});
  page.claim({.quantity = "peak above the ground",
              .unit = "m",
              .expected = law_of_peak(depth, beta, h),
              .source = "a throw at βd/h, step by step",
              .measured = peak(sunk(depth, {beta}), h),
              .tolerance = absolute(1e-9),
              .claimed = depth > law && speed / gravity < pop_seconds,
              .range = "deeper than that, up within 1.5 s"});
  page.claim({.quantity = "peak above the ground with the limit on the speed",
              .unit = "m",
              .expected = cap < harmless_speed(beta, h) ? 0 : cap * cap / (2 * gravity),
              .source = "it stays down, or v²/2g",
              .measured = peak(sunk(depth, {.beta = beta, .speed_cap = cap}), h),
              .tolerance = at_most(),
              .claimed = std::abs(cap / harmless_speed(beta, h) - 1) > 0.05,
              .range = "a limit not within 5 % of harmless"});
}

}  // namespace byhand::contact
