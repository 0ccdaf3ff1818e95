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

byhand::Setting by_sweeps() { return {AnyStepping{GaussSeidel{}, Baumgarte{0.2}}}; }

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

/// "bobs in the plane" is "bobs, plane" below a bar.
std::string short_name(std::string model) {
  for (const auto& [words, shorter] : {std::pair{" in the plane that could touch", ", may touch"},
                                       {" in the plane", ", plane"},
                                       {" in space", ", space"}})
    if (const auto place = model.find(words); place != std::string::npos)
      return model.replace(place, std::string::npos, shorter);
  return model;
}

/// ns a frame and body of each, one after the other.
renderer::Chart clocked(std::string_view scene, const Values& values, const std::vector<std::string>& models,
                        double bodies) {
  renderer::Chart chart{.y = {.label = "time (ns per body and step, 10 sweeps)"}};
  renderer::Bars bars;
  for (const std::string& model : models) {
    chart.bar_names.push_back(short_name(model));
    bars.values.push_back(nanoseconds_a_frame(Problem(scene, values, model), by_sweeps(), 0.1) / bodies);
  }
  chart.bars = {bars};
  return chart;
}

/// The same rule in the forces of constraints and in the numbers that these leave free.
struct Reduced {
  Problem problem;
  int numbers = 0, rows = 0;
  byhand::Point by_forces = {}, by_joints = {};

  double cheaper() const { return by_forces.cost / by_joints.cost; }
};

std::vector<Reduced> reduced(const Page& page) {
  std::vector<Reduced> all;
  for (const char* model : {"bobs in the plane", "links in the plane", "links in space"})
    for (const double links : {2.0, 10.0, 50.0})
      all.push_back({Problem("chain", {{"links", links}, {"end_mass", 10}, {"angle", 60}}, model)});
  const auto runs = page.side_by_side(2 * static_cast<int>(all.size()), [&](int i) {
    return measure(all[static_cast<std::size_t>(i / 2)].problem,
                   family_named(i % 2 == 0 ? "RK4" : "generalised RK4"), {.substeps = 8}, {.seconds = 2});
  });
  for (std::size_t i = 0; i < all.size(); ++i) {
    const AnyScene start = all[i].problem.start();
    all[i].numbers = start.degrees_of_freedom(), all[i].rows = start.rows();
    all[i].by_forces = runs[2 * i], all[i].by_joints = runs[2 * i + 1];
  }
  return all;
}

/// "to the last bit", "to rounding", "to 3 mm".
std::string agreeing(double apart) {
  return apart == 0 ? "to the last bit" : apart < 1e-11 ? "to rounding" : say("to @ m", Value(apart, 2));
}

/// What the cheapest run of a method costs, with 1 to 512 substeps a frame, whose error stays below `at_most`;
/// infinite if there is none.
double cheapest(const Problem& problem, const char* method, Error error, double at_most) {
  const Family& family = family_named(method);
  for (int substeps = 1; substeps <= 512; substeps *= 2) {
    Knobs knobs = with_cure({}, family.cures.front());
    knobs.substeps = substeps;
    const byhand::Point point = measure(problem, family, knobs, {.seconds = 2});
    if (point.has(error) && point[error] <= at_most) return point.cost;
  }
  return INFINITY;
}

constexpr std::array rivals{"direct", "RATTLE", "RK4", "generalised Euler", "generalised RK4"};
bool by_joints(std::string_view method) { return method.starts_with("generalised"); }

/// An error wanted of a chain, and what each rival needs for it.
struct Contest {
  const Problem* problem;
  Error error;
  double wanted;
  std::vector<double> costs = {};

  /// How many times dearer the best by forces is than the best by joints.
  double won_by() const {
    double forces = INFINITY, joints = INFINITY;
    for (std::size_t i = 0; i < rivals.size(); ++i) {
      double& least = by_joints(rivals[i]) ? joints : forces;
      least = std::min(least, costs[i]);
    }
    return forces / joints;
  }
};

std::vector<Contest> contests(const Page& page, const std::vector<Reduced>& chains) {
  std::vector<Contest> all;
  for (const Reduced& one : chains)
    if (one.problem["links"] == 10)
      for (const auto& [error, wanted] : {std::pair{Error::drift, 1e-2},
                                          {Error::drift, 1e-6},
                                          {Error::trajectory, 1e-2},
                                          {Error::trajectory, 1e-6}})
        all.push_back({&one.problem, error, wanted});
  const int count = static_cast<int>(rivals.size());
  const std::vector<double> costs = page.side_by_side(count * static_cast<int>(all.size()), [&](int i) {
    const Contest& one = all[static_cast<std::size_t>(i / count)];
    return cheapest(*one.problem, rivals[static_cast<std::size_t>(i % count)], one.error, one.wanted);
  });
  for (std::size_t i = 0; i < costs.size(); ++i) all[i / rivals.size()].costs.push_back(costs[i]);
  return all;
}

/// One number a hinge, and no row: what it saves, and what it cannot do.
void reduced_model(Page& page) {
  const std::vector<Reduced> all = reduced(page);
  std::vector<std::vector<std::string>> rows;
  double opened = 0, least = INFINITY, least_shown = INFINITY, most_shown = 0, apart = 0;
  for (const Reduced& one : all) {
    const double links = one.problem["links"];
    if (links == 10)  // per link they hardly change with the links
      rows.push_back(
          {one.problem.model(), say("@", links), say("@", one.numbers / links), say("@", one.rows / links),
           say("@", (one.numbers - one.rows) / links), say("@", Value(one.by_forces.cost / links, 3)),
           say("@", Value(one.by_joints.cost / links, 3)), say("@", Value(one.by_forces[Error::trajectory], 2)),
           say("@", Value(one.by_joints[Error::trajectory], 2)), say("@", Value(one.by_forces[Error::drift], 2))});
    opened = std::max(opened, one.by_joints[Error::drift] / links);
    least = std::min(least, one.cheaper());
    if (links == 10)
      least_shown = std::min(least_shown, one.cheaper()), most_shown = std::max(most_shown, one.cheaper());
    apart = std::max(apart, one.by_joints[Error::trajectory] / one.by_forces[Error::trajectory]);
  }
  page.text(
      R"(*Coordinates*: a link of a chain moves with three numbers in the plane, and the two rows of its pin take two
      of them back. One number is left, its angle. **Generalised coordinates** integrate that number alone: no rows, no
      λ, no drift. Here is RK4 both ways, with eight substeps a frame, on chains that swing from @° with an end of @
      kg. They have 10 links; numbers, rows and instructions a frame are per link.)",
      all.front().problem["angle"], all.front().problem["end_mass"]);
  page.table({"model", "links", "numbers", "rows", "free", "instructions, by forces", "by joints",
              "trajectory (m), by forces", "by joints", "drift (m), by forces"},
             rows);
  page.text(
      R"(With the same rule and step a frame takes @ to @ times as many instructions by forces as by joints, and joints
      open by rounding alone: @ m a link. But the rule is yours to choose. Here each method takes the fewest substeps
      (1, 2, 4 … 512) that keep an error on such a chain; the entries are instructions a frame for all ten links, the direct solve has β =
      0.2:)",
      Value(least_shown, 2), Value(most_shown, 2), Value(opened, 2));

  const std::vector<Contest> asked = contests(page, all);
  std::vector<std::string> head{"model", "error", "at most (m)"};
  head.insert(head.end(), rivals.begin(), rivals.end());
  head.push_back("best by forces / by joints");
  rows.clear();
  int wins = 0;
  struct Range {
    double least = INFINITY, most = 0;
  } place, tight, loose;
  for (const Contest& one : asked) {
    std::vector<std::string> row{one.problem->model(), std::string(name_of(one.error)), say("@", one.wanted)};
    for (const double cost : one.costs) row.push_back(std::isfinite(cost) ? say("@", Value(cost, 3)) : "none");
    row.push_back(std::isfinite(one.won_by()) ? say("@", Value(one.won_by(), 2)) : "∞");
    rows.push_back(std::move(row));
    wins += one.won_by() > 1;
    Range& range = one.error == Error::trajectory ? place : one.wanted < 1e-3 ? tight : loose;
    range.least = std::min(range.least, one.won_by()), range.most = std::max(range.most, one.won_by());
  }
  page.table(head, rows);
  const Problem four_bar("four_bar"), stack("stack", {{"boxes", 3}});
  const Method method = family_named("generalised RK4").setting({}).method;
  const std::string for_tight = page.verdict(
      {{.when = Quantity("forces over joints, drift of 10⁻⁶ m, least", tight.least) >= 2,
        .say = say("**For a tight drift** they win, because they have none: forces cost @ to @ times as much.",
                   Value(tight.least, 2), Value(tight.most, 2))}});
  const std::string for_loose = page.verdict(
      {{.when = Quantity("forces over joints, drift of 1 cm, largest", loose.most) <= 1,
        .say = say("**For a loose drift** they lose: the direct solve with β costs @ to @ of what they do.",
                   Value(loose.least, 2), Value(loose.most, 2))}});
  const std::string for_place = page.verdict(
      {{.when = Quantity("forces over joints, trajectory, largest", place.most) <= 2,
        .say =
            say(R"(**To be in the right place** they save little: forces cost @ to @ times as much. The rule alone
                      decides how many steps it takes, and a direct solve in the order of the graph also works in
                      proportion to the links.)",
                Value(place.least, 2), Value(place.most, 2))}});
  page.text(
      R"(Joint coordinates win @ of these @. @ @ @ Where they cannot be used the program says so. A loop: *@*. A
      stack: *@*. Nor is a reduced motion exact: its error is that of the rule, and semi-implicit Euler in joint
      angles, the default of several robotics engines, has order 1.)",
      wins, asked.size(), for_tight, for_loose, for_place, four_bar.start().refusal(method),
      stack.start().refusal(method));
  page.claim("generalised coordinates: largest opening of a joint, over the links", opened, "m",
             is_at_most(1e-13, "C = 0 by construction"));
  page.claim("instructions by forces over those by joints, same rule and step, least", least, "1",
             is_at_least(1, "no rows are written, none is solved"));
  page.claim("trajectory error by joints over that by forces, largest", apart, "1",
             is_at_most(3, "the same rule of order 4"));
  page.claim("best by forces over best by joints, a drift of 10⁻⁶ m, least", tight.least, "1",
             is_at_least(2, "by joints there is no drift"));
  page.claim("the same, a drift of 1 cm, largest", loose.most, "1", is_at_most(1, "one solve a frame is enough"));
  page.claim("the same, a trajectory, largest", place.most, "1",
             is_at_most(2, "both are proportional to the links, and the rule decides"));
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
      R"(Before a method costs anything, the *model* does. A bob on a rod can be a particle in the plane. It can also
      be a body in space, with a quaternion and an inertia, though the rod holds its centre and nothing turns it. Here
      is one chain of @ bobs and one pendulum, each in four models.)",
      links);
  page.predict(
      {.ask =
           R"(Ignoring the rods, how many times more degrees of freedom does the chain of bodies in space have than the
              chain of particles in the plane?)",
       .answer = static_cast<double>(most.degrees) / least.degrees,
       .unit = "1",
       .tolerance = 0.1,
       .wrong = {{1.5, "That is one more axis to move along. A body in space also turns, about three axes."},
                 {2, "Three axes to move along, and three to turn about."}},
       .hints = {"Count axes to move along and axes to turn about.", "numbers of a body = axes along + axes about",
                 "Particle in the plane: 2 + 0. Body in space: 3 + 3."},
       .right = say("@ instead of @ a body.", most.degrees / links, least.degrees / links)});
  double chain_apart = 0, pendulum_apart = 0;
  for (const Built& built : models) chain_apart = std::max(chain_apart, built.apart);
  for (const Built& built : pendulums) pendulum_apart = std::max(pendulum_apart, built.apart);
  page.text(
      R"(A row takes @ bytes between particles in the plane and @ between bodies in space; a step takes @ row-solves, the
      same rows in the same order. The motion is the same: over @ s @.)",
      least.row_bytes / links, most.row_bytes / links,
      least.row_solves == most.row_solves ? say("@", least.row_solves)
                                          : say("@ and @", least.row_solves, most.row_solves),
      2.0,
      agreeing(chain_apart) == agreeing(pendulum_apart)
          ? say("both the chains and the pendulums agree @", agreeing(chain_apart))
          : say("the chains agree @, the pendulums @", agreeing(chain_apart), agreeing(pendulum_apart)));
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
      costs:)",
      agreeing(linked[1].apart));
  page.clocked(
      "models_clocked",
      R"(The chain in each model by the clock: a step of ten sweeps, per body, at the moment of the run. The last three
      bars: stiff links without a shape, with one, and in space.)",
      [=] {
        std::vector<std::string> all = held_by_centres;
        all.insert(all.end(), with_and_without.begin(), with_and_without.end());
        return clocked("chain", values, all, links);
      });
  page.claim("links that could touch, from those that cannot", linked[1].apart, "m",
             is(0, "the same rows in the same order", absolute(0)));

  reduced_model(page);
}

}  // namespace byhand::accuracy
