// Step 6: what all charts say together: performance profiles, and a table of advice.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/catalogue/limits.hpp"
#include "lessons/catalogue/profile.hpp"
#include "lessons/catalogue/tidy.hpp"

namespace byhand::accuracy {
namespace {

constexpr double most_ratio = 100;        // τ of a profile, at most
constexpr std::size_t most_profiles = 7;  // that can be told apart

struct Class {
  std::string name;
  Problem problem;
  double most;
  int runs;
};

const std::vector<Class>& equalities() {
  static const std::vector<Class> all{
      {"one rod", Problem("pendulum", {{"length", 2}, {"mass", 3}}), swing_most, 300},
      {"two links", Problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}}), swing_most, 300},
      {"a chain of 10", Problem("chain", {{"links", 10}}), 2.5e5, 80},
      {"a heavy end on 50 links", Problem("chain", {{"links", 50}, {"end_mass", 100}}), 6e5, 60},
      {"a loop of bars", Problem("four_bar", {{"length", 2}, {"mass", 3}, {"coupler_mass", 3}}), swing_most, 300},
      {"a rod in space", Problem("spherical_pendulum", {{"length", 2}, {"mass", 3}}), swing_most, 300},
      {"a spinning top", Problem("top"), swing_most, 300}};
  return all;
}
const std::vector<Class>& contact_scenes() {
  static const std::vector<Class> all{
      {"a stack of 10", Problem("stack", {{"boxes", 10}, {"kick", 0.02}}), 1.5e5, 80},
      {"a heavy box on 4", Problem("stack", {{"boxes", 5}, {"top_mass", 100}, {"kick", 0.02}}), 1.5e5, 60},
      {"a pyramid of 21", Problem("pyramid", {{"base", 6}, {"kick", 0.02}}), 3e5, 50},
      {"a sliding block", Problem("incline"), swing_most, 300}};
  return all;
}

std::vector<Error> watched_of(const Problem& problem) {
  if (problem.scene().duty == Duty::stand) return {Error::drift, Error::trajectory, Error::contact};
  if (problem.scene().duty == Duty::slide) return {Error::drift, Error::trajectory};
  return problem.scene().keeps_spin ? spin_errors : swing_errors;
}

const Survey& survey_of(const Page& page, const Class& one) {
  return survey(page, one.problem, watched_of(one.problem), one.most, one.runs);
}

/// The errors and targets that count: lengths by a body's, the others as they are.
std::vector<std::pair<Error, double>> targets_of(const Problem& problem) {
  std::vector<std::pair<Error, double>> targets;
  for (const Error error : watched_of(problem)) {
    if (error == Error::contact) continue;
    const bool length = error == Error::drift || error == Error::trajectory;
    for (const double share : {1e-2, 1e-3, 1e-4})
      targets.emplace_back(error, length ? share * problem.size() : 10 * share);
  }
  return targets;
}

struct Tasks {
  std::vector<Task> tasks;
  std::string data = "class,error kind,error wanted,unit,method,cost (instructions a frame),time (ns a frame)\n";
};

/// What each method costs at each scene, error and target; by the clock with a time for each run that is needed.
Tasks tasks_of(const Page& page, const std::vector<Class>& classes, Cost cost) {
  Tasks all;
  for (const Class& one : classes) {
    const Survey& survey = survey_of(page, one);
    for (const auto& [error, wanted] : targets_of(one.problem)) {
      Task task{say("@, @, @", one.name, std::string(name_of(error)), wanted), {}};
      for (const Family& family : families()) {
        const auto cheapest = best(page, survey, family, error, wanted);
        const double spent = !cheapest ? INFINITY
                             : cost == Cost::counted
                                 ? cheapest->cost
                                 : nanoseconds_a_frame(one.problem, family.setting(cheapest->knobs), 0.002);
        task.cost.push_back(spent);
        all.data +=
            say("@,@,@,@,@,@,@\n", one.name, std::string(name_of(error)), wanted, std::string(unit_of(error)),
                family.name, cost == Cost::counted && std::isfinite(spent) ? say("@", Value(spent, 6)) : "",
                cost == Cost::wall_time && std::isfinite(spent) ? say("@", Value(spent, 6)) : "");
      }
      all.tasks.push_back(std::move(task));
    }
  }
  return all;
}

/// All methods that do a task, by the area under their profiles, the largest first.
std::vector<std::size_t> by_area(const std::vector<Task>& tasks) {
  std::vector<std::pair<double, std::size_t>> areas;
  for (std::size_t i = 0; i < families().size(); ++i) {
    const Profile profile(tasks, i);
    double area = 0;
    for (double tau = 1; tau < most_ratio; tau *= 1.05) area += profile(tau);
    if (area > 0) areas.emplace_back(-area, i);
  }
  std::stable_sort(areas.begin(), areas.end());
  std::vector<std::size_t> methods;
  for (const auto& [area, method] : areas) methods.push_back(method);
  return methods;
}

/// " Not drawn, with less area below: Jacobi. …": who has no curve, and why.
std::string left_out(const std::vector<Task>& tasks) {
  const std::vector<std::size_t> methods = by_area(tasks);
  std::string less, none;
  const auto add = [](std::string& list, const std::string& name) { list += (list.empty() ? "" : ", ") + name; };
  for (std::size_t i = most_profiles; i < methods.size(); ++i) add(less, families()[methods[i]].name);
  for (std::size_t i = 0; i < families().size(); ++i)
    if (std::find(methods.begin(), methods.end(), i) == methods.end()) add(none, families()[i].name);
  return (less.empty() ? "" : say(" Not drawn, with less area under their curves: @.", less)) +
         (none.empty() ? "" : say(" For up to @ times the least cost these solve none: @.", most_ratio, none));
}

/// The profiles of the methods with the largest area under theirs.
renderer::Chart profiles(const std::vector<Task>& tasks, Cost cost) {
  using namespace renderer;
  std::vector<std::size_t> drawn = by_area(tasks);
  if (drawn.size() > most_profiles) drawn.resize(most_profiles);
  Chart chart{.x = {.label = cost == Cost::wall_time ? "τ: at most this many times the time of the fastest"
                                                     : "τ: at most this many times the cost of the cheapest",
                    .scale = Scale::logarithmic,
                    .range = {{1, most_ratio}}},
              .y = {.label = "share of all tasks", .range = {{0, 1}}}};
  for (const std::size_t method : drawn) {
    const Profile profile(tasks, method);
    Curve curve{.label = families()[method].name, .place = pictures::place_of(families()[method].name)};
    double before = profile(1);
    curve.x = {1}, curve.y = {before};
    for (const double ratio : profile.ratios()) {
      if (ratio <= 1 || ratio > most_ratio) continue;
      curve.x.insert(curve.x.end(), {ratio, ratio});
      curve.y.insert(curve.y.end(), {before, profile(ratio)});
      before = profile(ratio);
    }
    curve.x.push_back(most_ratio), curve.y.push_back(before);
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

/// "Cheapest most often: direct, in 46 % of the tasks".
std::string winner(const std::vector<Task>& tasks, const std::string& called) {
  std::string best;
  double most = -1;
  for (std::size_t i = 0; i < families().size(); ++i)
    if (const double share = Profile(tasks, i)(1); share > most) most = share, best = families()[i].name;
  return say("@: @, in @ % of the tasks", called, best, Value(100 * most, 2));
}

/// What solves most tasks at the least cost, and at any, in words.
std::string winners(const std::vector<Task>& tasks) {
  std::string steady;
  double widest = -1;
  for (std::size_t i = 0; i < families().size(); ++i) {
    const Profile profile(tasks, i);
    if (profile(1e300) > widest) widest = profile(1e300), steady = families()[i].name;
  }
  return say("@. Most tasks solved at any cost: @, @ %.", winner(tasks, "Cheapest most often"), steady,
             Value(100 * widest, 2));
}

/// In which of its other errors a run is bad: a tenth and more.
std::string warning(const byhand::Point& point) {
  std::string bad;
  for (const Error error : {Error::energy, Error::momentum, Error::reaction})
    if (point.has(error) && point[error] > 0.1) bad += (bad.empty() ? "" : ", ") + std::string(name_of(error));
  return bad.empty() ? "" : " (bad: " + bad + ")";
}

std::string law_of(const Problem& problem) {
  const LawLimit limit = limit_of(problem);
  return limit.law == 0 ? "–" : say("@: @", limit.law, limit.number);
}

}  // namespace

void one_page(Page& page) {
  page.text(
      R"(Many charts, and one decision. A *performance profile* (E. D. Dolan and J. J. Moré, 2002) puts all of them
      into one picture. A task is a scene, an error and a target. A method solves it if its error stays below the target
      from 19 of 20 initial conditions, on none of which it was tuned. Each method's curve is the share of tasks that
      it solves for at most τ times the cost of the cheapest method. So its height at τ = 1 says how often the
      method is the cheapest, its height at the right edge how often it solves the task at all. Rankings below
      first place depend on which other methods are included (N. Gould and J. Scott, 2016).)");
  const Tasks joints = tasks_of(page, equalities(), Cost::counted),
              touching = tasks_of(page, contact_scenes(), Cost::counted);
  page.figure("profile_equalities",
              say("Rods and joints: @ tasks, three targets for each error of each of @ scenes.",
                  joints.tasks.size(), equalities().size()) +
                  left_out(joints.tasks),
              profiles(joints.tasks, Cost::counted), joints.data);
  page.text("Rods and joints. " + winners(joints.tasks));
  page.figure("profile_contacts",
              say("Contacts: @ tasks in @ scenes, which first have to stand or slide.", touching.tasks.size(),
                  contact_scenes().size()) +
                  left_out(touching.tasks),
              profiles(touching.tasks, Cost::counted), touching.data);
  page.text("Contacts. " + winners(touching.tasks));
  page.clocked(
      "profile_equalities_clocked",
      R"(Rods and joints by the clock: the same tasks and runs, by the median time of a frame at the moment of
               the run.)",
      [] {
        const std::vector<Task> tasks = tasks_of(Page(), equalities(), Cost::wall_time).tasks;
        renderer::Chart chart = profiles(tasks, Cost::wall_time);
        chart.title = winner(tasks, "Fastest most often");
        return chart;
      });

  page.text(
      R"(And here is what to use, from the same runs. For each kind of scene and each accuracy: the cheapest run that
      keeps it from 19 of 20 initial conditions, with its choices, its cost in thousands of instructions per frame, and
      the law of lesson 8 that limits it, with that law's number at one step a frame. Accuracies are shares of a body's
      length; ω and β are tuned to this very scene.)");
  const std::vector<std::string> head{
      "scene", "accuracy", "to keep it together (drift)", "cost", "to be in the right place (trajectory)",
      "cost",  "law"};
  std::vector<std::vector<std::string>> rows;
  int empty = 0, asked = 0;
  for (const auto* classes : {&equalities(), &contact_scenes()})
    for (const Class& one : *classes) {
      const Survey& survey = survey_of(page, one);
      for (const double share : {1e-2, 1e-4}) {
        std::vector<std::string> row{one.name, say("@ %", 100 * share)};
        for (const Error error : {Error::drift, Error::trajectory}) {
          std::optional<byhand::Point> cheapest;
          for (const Family& family : families())
            if (const auto found = best(page, survey, family, error, share * one.problem.size());
                found && (!cheapest || found->cost < cheapest->cost))
              cheapest = found;
          ++asked, empty += !cheapest;
          row.push_back(cheapest ? cheapest->described() + warning(*cheapest) : "none here");
          row.push_back(cheapest ? say("@", Value(cheapest->cost / 1000, 2)) : "–");
        }
        row.push_back(law_of(one.problem));
        rows.push_back(std::move(row));
      }
    }
  page.table(head, rows);
  page.claim("share of this table that some method does", 1 - static_cast<double>(empty) / asked, "1",
             is_at_least(0.9, "the targets are within reach"));
}

}  // namespace byhand::accuracy
