// Deeper: the same motion with more numbers than it needs.

#include <chrono>

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"

namespace byhand::accuracy {
namespace {

/// A scene of the catalogue as one model, and what it came to.
struct Built {
  std::string model;
  int degrees = 0, rows = 0;
  double scene_bytes = 0, row_bytes = 0;
  double row_solves = 0;  // a frame
  double apart = 0;       // the largest distance of any body from that of the first model, over the run [m]
};

byhand::Setting by_sweeps(BlockSolve block_solve = BlockSolve::whole) {
  GaussSeidel solver;
  solver.block_solve = block_solve;
  return {AnyStepping{solver, Baumgarte{0.2}}};
}

std::vector<Built> build(std::string_view scene, const Values& values, const std::vector<std::string>& models,
                         double duration) {
  std::vector<std::vector<Placement>> first;
  std::vector<Built> all;
  for (const std::string& model : models) {
    AnyScene running = Problem(scene, values, model).start();
    running.use(by_sweeps().method);
    Built built{model, running.degrees_of_freedom(), running.rows(), static_cast<double>(running.scene_bytes()),
                static_cast<double>(running.row_bytes())};
    const auto frames = static_cast<std::size_t>(std::lround(duration / frame));
    for (std::size_t i = 0; i < frames; ++i) {
      running.step(frame);
      const std::vector<Placement> now = running.placements();
      if (all.empty()) {
        first.push_back(now);
        continue;
      }
      for (std::size_t body = 0; body < now.size(); ++body)
        built.apart = std::max(built.apart, (now[body].position - first[i][body].position).norm());
    }
    built.row_solves = static_cast<double>(running.row_solves()) / static_cast<double>(frames);
    all.push_back(built);
  }
  return all;
}

renderer::Chart numbers(const std::vector<Built>& models, double bodies) {
  renderer::Chart chart{.y = {.label = "a body: numbers it moves with, and bytes of its state and rows over 8"}};
  renderer::Bars degrees{.label = "degrees of freedom"}, scene{.label = "state and constraint (8 bytes)"},
      rows{.label = "its row, ready to solve (8 bytes)"};
  for (const Built& built : models) {
    chart.bar_names.push_back(built.model);
    degrees.values.push_back(built.degrees / bodies);
    scene.values.push_back(built.scene_bytes / 8 / bodies);
    rows.values.push_back(built.row_bytes / 8 / bodies);
  }
  chart.bars = {degrees, scene, rows};
  return chart;
}

/// ns a frame and body of each, one after the other.
renderer::Chart clocked(std::string_view scene, const Values& values, const std::vector<std::string>& models,
                        double bodies) {
  renderer::Chart chart{.y = {.label = "time (ns a body and step of 10 sweeps)"}};
  renderer::Bars bars;
  for (const std::string& model : models) {
    chart.bar_names.push_back(model);
    bars.values.push_back(nanoseconds_a_frame(Problem(scene, values, model), by_sweeps(), 0.1) / bodies);
  }
  chart.bars = {bars};
  return chart;
}

/// "to the last bit", "to rounding", "to 3 mm".
std::string agreeing(double apart) {
  return apart == 0 ? "to the last bit" : apart < 1e-11 ? "to rounding" : say("to @ m", Value(apart, 2));
}

}  // namespace

void model_cost(Page& page) {
  const std::vector<std::string> held_by_centres{"bobs in the plane", "balls in the plane", "bobs in space",
                                                 "balls in space"};
  const int links = 50;
  const Values values{{"links", links}, {"length", 2}, {"mass", 3}, {"end_mass", 3}};
  const auto models = build("chain", values, held_by_centres, 2);
  const auto pendulums = build("pendulum", {{"length", 2}, {"mass", 3}}, held_by_centres, 2);
  const Built &least = models.front(), &most = models.back();

  page.text(
      R"(Before a method costs anything, the *model* does. A bob on a rod needs two numbers to move with. As a body in
      space it has six, and a quaternion and an inertia, though the rod holds its centre and nothing turns it. Here is
      one chain of @ bobs and one pendulum, each in four models.)",
      links);
  page.predict(
      {.ask = R"(The chain as bodies in space: how many times as many numbers does it move with as the chain of
              particles in the plane?)",
       .answer = static_cast<double>(most.degrees) / least.degrees,
       .unit = "1",
       .tolerance = 0.1,
       .wrong = {{1.5, "That is one axis more to move along. A body in space also turns, about three."},
                 {2, "Three axes to move along, and three to turn about."}},
       .hints = {"Count axes to move along and axes to turn about.", "numbers of a body = axes along + axes about",
                 "Particle in the plane: 2 + 0. Body in space: 3 + 3."},
       .right = say("@ instead of @ a body.", most.degrees / links, least.degrees / links)});
  page.figure("models",
              R"(What one body of the chain takes in each model, with its rod: the numbers it moves with, its state
              (pose, velocity, inverse mass, constraint) and its row of (6), (18) with what is kept of it.)",
              numbers(models, links));
  double chain_apart = 0, pendulum_apart = 0;
  for (const Built& built : models) chain_apart = std::max(chain_apart, built.apart);
  for (const Built& built : pendulums) pendulum_apart = std::max(pendulum_apart, built.apart);
  page.text(
      R"(A body's row takes @ bytes with particles in the plane and @ with bodies in space; a step takes @ and @
      row-solves, the same rows in the same order. The motion is the same: after @ s all four chains agree @, the
      pendulums @.)",
      least.row_bytes / links, most.row_bytes / links, least.row_solves, most.row_solves, 2.0,
      agreeing(chain_apart), agreeing(pendulum_apart));
  page.clocked(
      "models_clocked",
      R"(The same four chains by the clock: one step of ten sweeps, over the number of bodies. Measured on the
      machine and at the moment of the run.)",
      [=] { return clocked("chain", values, held_by_centres, links); });
  for (const Built& built : models)
    page.claim("numbers a body moves with, " + built.model, static_cast<double>(built.degrees) / links, "1",
               is(built.model == "bobs in the plane" ? 2.0
                  : built.model == "balls in space"  ? 6.0
                                                     : 3.0,
                  "axes to move along and to turn about", absolute(0)));
  page.claim("four chains, largest distance between any two models", chain_apart, "m",
             is_at_most(1e-8, "the same physics: rounding, and what a swinging chain makes of it in 2 s"));
  page.claim("four pendulums, the same", pendulum_apart, "m", is_at_most(1e-12, "the same physics: rounding"));

  const std::vector<std::string> with_and_without{"links in the plane", "links in the plane that could touch",
                                                  "links in space"};
  const auto linked = build("chain", values, with_and_without, 2);
  page.text(
      R"(Two more costs are easily overlooked. *Shapes*: as soon as a body has one, every step looks for contacts. Here
      one link has a shape and no contact is ever found; the two motions agree @. The clock shows what the search
      costs. For one shape that is little; many shapes cost more.)",
      agreeing(linked[1].apart));
  page.clocked(
      "touch_clocked",
      R"(The chain of stiff links, without a shape, with one, and in space. Measured on the machine and at the
      moment of the run.)",
      [=] { return clocked("chain", values, with_and_without, links); });
  page.claim("links that could touch, from those that cannot", linked[1].apart, "m",
             is(0, "the same rows in the same order", absolute(0)));

  const Problem chain("chain", {{"links", 10}, {"length", 2}, {"mass", 3}, {"end_mass", 3}});
  const double whole = error_of(chain, by_sweeps(BlockSolve::whole), Error::drift),
               rows = error_of(chain, by_sweeps(BlockSolve::row_by_row), Error::drift);
  page.text(
      R"(*Blocks*: a pin is two rows that share both bodies. Solved as one block, with a 2 × 2 inverse, the two cannot
      undo each other. On @ such links, ten sweeps a step leave a largest separation of @ m that way and of @ m row by
      row, for the same row-solves. (A body of small inertia at the end of an arm shows the difference better: lesson 6.))",
      chain["links"], Value(whole, 3), Value(rows, 3));
  page.measure("drift, blocks of two rows", whole, "m");
  page.measure("drift, row by row", rows, "m");
}

}  // namespace byhand::accuracy
