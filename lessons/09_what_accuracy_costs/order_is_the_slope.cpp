// Step 1: how to read a work–precision chart.

#include <cmath>
#include <numbers>

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::accuracy {
namespace {

using namespace tutor;

/// By how much halving the step divides an error, from four steps a frame on.
template <class ErrorOf>
double gain(const ErrorOf& error) {
  return std::abs(error(4) / error(8));
}

double gain_in_place(const Problem& problem, const Configuration& configuration, double tuning) {
  return gain([&](int steps) { return measure(problem, configuration, steps, tuning)[Error::trajectory]; });
}
double gain_in_period(const Problem& problem, const Configuration& configuration, double tuning) {
  const SimplePendulum exact(problem["angle"] * std::numbers::pi / 180, problem["length"], problem["gravity"]);
  return gain([&](int steps) { return period(problem, configuration.setting(steps, tuning)) - exact.period(); });
}

}  // namespace

void order_is_the_slope(Page& page) {
  const Problem problem("pendulum", {{"length", 2}, {"mass", 3}});
  page.text(
      R"(Eight lessons gave you methods and knobs. Which one, then, and how far turned? Not a matter of taste: run
      them all on a scene whose true motion is known, and draw what each gets wrong against what it costs.

      Begin with a bob of @ kg on a rod of @ m, let go level, whose angle after a second elliptic functions give to
      the last digit. Each curve below is one method; each point on it one run, with the number of steps or sweeps
      a frame of 1/60 s written at it. To the left: less error. Down: less work. So **down and left is good**, and
      what no other run beats in both lies on the broad staircase, the *front*.)",
      problem["mass"], problem["length"]);
  const Survey& all = survey(page, problem, Error::trajectory);
  show(page, "pendulum_trajectory", all, Error::trajectory);
  page.text(
      R"(Work is counted in *row-solves*, (17) and (20) once each, which are the same on every machine; a direct
      solve is charged the row-solves that its multiplications would buy. What your machine's clock says of it
      comes next, and it never decides anything in this course.)");
  show_clocked(page, "pendulum_trajectory_clocked", all, Error::trajectory);
  page.text(
      R"(Both axes are logarithmic, so a power law is a straight line: where the error falls as hᵖ and the cost
      grows as 1/h, ten times the cost go p decades to the left. That p is the *order*, and the legend has it as it
      was fitted. What does it buy?)");
  const Configuration& euler = configuration_named("direct, substeps");
  const Configuration& rattle = configuration_named("RATTLE, substeps");
  const double first = gain_in_place(problem, euler, 1), second = gain_in_place(problem, rattle, 0);
  const auto nearest = [](double ratio) { return std::log2(ratio) < 1.5 ? 2 : 4; };
  tutor::Choice question{
      .ask =
          R"(Halve the time step. The error of the bob's *place* after a second is divided by what, with symplectic
          Euler (β = 1), and with RATTLE?)",
      .hints = {"Look at the legend: an error of order p is divided by 2ᵖ."}};
  for (const auto& [one, two] : {std::pair{2, 2}, std::pair{2, 4}, std::pair{4, 4}}) {
    if (nearest(first) == one && nearest(second) == two)
      question.answer = static_cast<int>(question.options.size());
    question.options.push_back(
        {say("@ and @", one, two),
         say("Measured: @ and @. Order is the slope on the chart.", Value(first, 3), Value(second, 3))});
  }
  page.choose(std::move(question));
  const double first_period = gain_in_period(problem, euler, 1),
               second_period = gain_in_period(problem, rattle, 0);
  page.text(
      R"(Ask for the *period* instead, from one passage through the lowest point to the next but one, and the
      answer is another: @ and @. Symplectic Euler runs round the same orbit as a method of order two, half a step
      behind it, and a clock that is late by the same amount for ever keeps good time. Which error you chart
      decides which order you see.)",
      Value(first_period, 3), Value(second_period, 3));
  page.claim({.quantity = "place after a second, symplectic Euler, h halved: error divided by",
              .unit = "1",
              .expected = 2,
              .source = "order 1",
              .measured = first,
              .tolerance = relative(0.05)});
  page.claim({.quantity = "the same, RATTLE",
              .unit = "1",
              .expected = 4,
              .source = "order 2",
              .measured = second,
              .tolerance = relative(0.05)});
  page.claim({.quantity = "period, symplectic Euler with β = 1, h halved: error divided by",
              .unit = "1",
              .expected = 4,
              .source = "conjugate to leapfrog, of order 2",
              .measured = first_period,
              .tolerance = relative(0.05)});
  page.claim({.quantity = "the same, RATTLE",
              .unit = "1",
              .expected = 4,
              .source = "order 2",
              .measured = second_period,
              .tolerance = relative(0.05)});
  page.text(
      R"(Two traps stand on this chart. Errors of opposite sign cancel, so a curve may dive where it has no right
      to: trust slopes over many points and never one lucky point. And every line ends somewhere: at the bottom
      left rounding waits, and the reference itself is only so sure (dotted).)");
  struct Expected {
    const char *configuration, *source;
    double order;
  };
  for (const auto& [name, source, order] : {Expected{"RATTLE, substeps", "symmetric: 2", 2},
                                            Expected{"implicit midpoint, substeps", "symmetric: 2", 2},
                                            Expected{"RK4, substeps", "four stages: 4", 4}})
    page.claim({.quantity = std::string("fitted order of ") + name,
                .unit = "1",
                .expected = order,
                .source = source,
                .measured = fitted_order(all.find(name)->points, Error::trajectory),
                .tolerance = absolute(0.2)});
}

}  // namespace byhand::accuracy
