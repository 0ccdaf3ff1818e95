// Step 4: what to do with a heavy chain: sweep longer, step more often, or solve all rows at once.

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {
namespace {

/// ", but change the energy by …": where the cheapest run in joint coordinates does, beside one that does not.
std::string price_in_energy(const Page& page, const Survey& all, double drift) {
  constexpr double bad = 0.1;  // of m·g·L
  const auto euler = best(page, all, family_named("generalised Euler"), Error::drift, drift),
             rk4 = best(page, all, family_named("generalised RK4"), Error::drift, drift);
  if (!euler || !((*euler)[Error::energy] > bad)) return "";
  std::string text = say(", but change the energy by @ m·g·L", Value((*euler)[Error::energy], 2));
  if (rk4 && (*rk4)[Error::energy] < bad) text += say("; with RK4 they cost @ and do not", Value(rk4->cost, 3));
  return text;
}

/// Least trajectory error over β for so many substeps of so many warm sweeps; of none: solved directly.
double best_error(const Problem& problem, int substeps, int sweeps) {
  double least = std::numeric_limits<double>::infinity();
  for (const double beta : {0.0, 0.05, 0.2, 0.5, 1.0}) {
    AnyStepping method{GaussSeidel{sweeps}, Baumgarte{beta}};
    if (sweeps == 0) method.solver = Direct{};
    method.substeps = substeps;
    least = std::min(least, error_of(problem, {method}, Error::trajectory));
  }
  return least;
}

}  // namespace

void substeps_or_sweeps(Page& page) {
  const Problem ten("chain", {{"links", 10}});
  const std::vector<std::pair<int, int>> ways{{1, 64}, {8, 8}, {64, 1}};
  const std::vector<double> error = page.side_by_side(3, [&](int i) {
    return best_error(ten, ways[static_cast<std::size_t>(i)].first, ways[static_cast<std::size_t>(i)].second);
  });
  const auto best = std::min_element(error.begin(), error.end()) - error.begin();

  page.text(
      R"(You have @ row-solves a frame for a swinging chain of @ links: @ sweeps. Do you spend them all on one step, or
      divide the step and sweep each part less?)",
      64 * ten["links"], ten["links"], 64);
  course::Choice question{
      .ask = "Which comes nearest to the true motion after a second (each with its best β)?",
      .answer = static_cast<int>(best),
      .hints = {"Two errors add up: that of the solver, and that of the step. Which does each way reduce?",
                "The step's error falls as h; a warm start carries λ on to the next substep.",
                "1 × 64: h/1. 8 × 8: h/8. 64 × 1: h/64."}};
  for (std::size_t i = 0; i < ways.size(); ++i) {
    const auto [substeps, sweeps] = ways[i];
    question.options.push_back(
        {say(substeps == 1 ? "@ step of @ sweeps"
             : sweeps == 1 ? "@ substeps of @ sweep"
                           : "@ substeps of @ sweeps",
             substeps, sweeps),
         substeps == 1 ? say("It solves very well a step that is itself wrong: @ m off.", Value(error[i], 2))
         : i != static_cast<std::size_t>(question.answer)
             ? say("@ m off: its step is still @ times as long as that of the best.", Value(error[i], 2),
                   ways[question.answer].first / substeps)
             : say(R"(@ m off. A warm start carries λ from substep to substep, so no sweep is wasted, and the
                   step's own error shrinks too.)",
                   Value(error[i], 2))});
  }
  page.choose(std::move(question));
  page.claim("64 × 1 over 1 × 64, error of the trajectory", error[2] / error[0], "1",
             is_at_most(1, "law of substeps or sweeps (lesson 8)"));

  const Problem in_space("chain", {{"links", 10}}, "links in space");
  const auto knobs_of = [](const std::pair<int, int>& way) {
    return Knobs{.substeps = way.first, .passes = way.second, .cure = Cure::baumgarte, .strength = 0.02};
  };
  const Family& gauss_seidel = family_named("Gauss–Seidel");
  std::vector<std::pair<std::string, std::vector<double>>> counted{{"counted, in the plane", {}},
                                                                   {"counted, in space", {}}};
  for (const auto& way : ways)
    for (const Problem* problem : {&ten, &in_space})
      counted[problem == &in_space].second.push_back(
          measure(*problem, gauss_seidel, knobs_of(way), {.seconds = 0.5, .reference = false}).cost);
  const auto over_one_step = [](std::vector<double> cost) {
    const double one_step = cost.front();
    for (double& one : cost) one /= one_step;
    return cost;
  };
  page.text(
      R"(That was at equal row-solves. But each substep also writes its rows anew, 64 times a frame instead of once:
      with that set-up @ × @ costs @ times as much as @ × @, and @ times as much for the same links in space, whose
      rows take more to write. The clock can differ either way: a sweep's rows wait for one another, which makes
      sweeps dearer; set-up reads more memory, which makes substeps dearer. Here are count and clock, each over one step of @ sweeps:)",
      ways.back().first, ways.back().second, Value(over_one_step(counted[0].second).back(), 2), ways.front().first,
      ways.front().second, Value(over_one_step(counted[1].second).back(), 2), ways.front().second);
  page.clocked(
      "ways_clocked",
      R"(Cost of a frame of the three ways over that of the first: counted, and by the clock at the moment of the run.)",
      [=] {
        renderer::Chart chart{.y = {.label = "cost of a frame over that of 1 × 64"}};
        auto all = counted;
        for (const auto& [problem, name] :
             {std::pair{ten, "clock, in the plane"}, std::pair{in_space, "clock, in space"}}) {
          std::vector<double> times;
          for (const auto& way : ways)
            times.push_back(nanoseconds_a_frame(problem, gauss_seidel.setting(knobs_of(way)), 0.1));
          all.emplace_back(name, times);
        }
        for (const auto& [substeps, sweeps] : ways) chart.bar_names.push_back(say("@ × @", substeps, sweeps));
        for (const auto& [name, costs] : all)
          chart.bars.push_back({.label = name, .values = over_one_step(costs)});
        return chart;
      });

  const double exact = best_error(ten, 1, 0), gained = error.front() / error.back();
  page.text(
      "For @ times the work the error falls by a factor of @. @",
      Value(over_one_step(counted[0].second).back(), 2), Value(gained, 2),
      page.verdict({{.when = Quantity("error of one step solved exactly, over that of 64 substeps",
                                      exact / error.back()) > 1,
                     .say = say("One step solved exactly is still @ m off. So substeps win.", Value(exact, 2))}}));

  const Problem heavy("chain", {{"links", 50}, {"end_mass", 100}});
  constexpr double most = 6e5;  // instructions per frame
  const Survey& all = survey(page, heavy, swing_errors, most, 150);
  page.text(
      R"(Now a hard case: @ links, the last @ times as heavy as the others, released level. By the laws of lesson 8
      each digit takes sweeps in proportion to the length and to the mass ratio, and no number of sweeps helps where
      the step is too long for light links under tension. All methods on it:)",
      heavy["links"], heavy["end_mass"] / heavy["mass"]);
  show(page, "chain_50_100_drift", all, Error::drift);

  const double wanted = 1e-4;
  const std::vector<std::string_view> by_sweeps{
      "Gauss–Seidel",        "symmetric Gauss–Seidel",          "Jacobi",
      "conjugate sweeps",    "conjugate sweeps to a tolerance", "conjugate gradients",
      "accelerated gradient"};
  const double direct = least_cost(page, all, Error::drift, wanted, {"direct"}),
               swept = least_cost(page, all, Error::drift, wanted, by_sweeps);
  page.text(
      R"(Compare the cheapest runs that drift by at most @ m, on a chain of @ m. A direct solve in the order of the
      chain (lesson 3), with substeps, costs @ instructions per frame, @ for each row. @)",
      wanted, heavy["links"] * heavy["length"], Value(direct, 3), Value(direct / heavy.start().rows(), 3),
      std::isfinite(swept) ? say("The cheapest sweeping method costs @, @ times as much.", Value(swept, 3),
                                 Value(swept / direct, 2))
                           : say("No sweeping method reaches that drift for up to @.", most));
  const double reduced = least_cost(page, all, Error::drift, wanted, {"generalised Euler", "generalised RK4"});
  page.text(page.verdict(
      {{.when = Quantity("joint coordinates over the direct solve", reduced / direct) < 1,
        .say = say("Generalised coordinates, which have no drift, hold the chain for @ instructions@.",
                   Value(reduced, 3), price_in_energy(page, all, wanted))}}));
  const double rattle = least_cost(page, all, Error::drift, wanted, {"RATTLE"}),
               rk4 = least_cost(page, all, Error::drift, wanted, {"RK4"});
  if (std::isfinite(rattle) && std::isfinite(rk4))
    page.text(R"(RATTLE, with the same kind of solve, costs @ and then drifts by rounding alone. RK4 costs @.)",
              Value(rattle, 3), Value(rk4, 3));
  page.claim(say("direct with substeps: drift of at most @ m", wanted), direct / heavy.start().rows(),
             "instructions a row",
             is_at_most(5000, "two rows a joint: at 3 instructions a nanosecond 3 µs a joint and frame"));
  page.claim(std::isfinite(swept) ? "the same by sweeps, over the direct solve"
                                  : "no sweeping method does it below this cost, over the direct solve",
             std::min(swept, most) / direct, "1", is_at_least(3, "sweeps a digit: length times mass ratio"));
}

}  // namespace byhand::accuracy
