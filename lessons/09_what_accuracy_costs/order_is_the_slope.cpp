// Step 2: how to read a work–precision chart.

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
      R"(A bob of @ kg on a rod of @ m is released level. Elliptic functions give its angle after a second to the last
      digit. Each curve below is one method, and each point of it one run, labelled with the number of substeps,
      sweeps or iterations in a frame of 1/60 s. The error grows to the right, the work grows upwards; so **down and
      left is good**. The broad staircase, the *front*, joins the runs that no other run beats in both.)",
      problem["mass"], problem["length"]);
  const Survey& all = survey(page, problem, Error::trajectory);
  show(page, "pendulum_trajectory", all, Error::trajectory);
  page.text(
      R"(Work is counted in *row-solves*, one use of (17) and (20) each, which are the same on every machine. A direct
      solve is charged the row-solves that its multiplications amount to. What a substep costs besides, writing its
      rows and finding its contacts, is not counted. The clock counts it; its chart comes next, and no statement of
      this course depends on it.)");
  show_clocked(page, "pendulum_trajectory_clocked", all, Error::trajectory);
  page.text(
      R"(Both axes are logarithmic, so a power law is a straight line. Where the error falls as hᵖ and the work grows as
      1/h, ten times the work moves a point by p decades to the left. That p is the *order* of the method; the legend
      gives the fitted one.)");
  const Configuration& euler = configuration_named("direct, substeps");
  const Configuration& rattle = configuration_named("RATTLE, substeps");
  const double first = gain_in_place(problem, euler, 1), second = gain_in_place(problem, rattle, 0);
  const auto nearest = [](double ratio) { return std::log2(ratio) < 1.5 ? 2 : 4; };
  tutor::Choice question{
      .ask =
          R"(Halve the time step. By what is the error of the bob's *place* after a second divided, with symplectic
          Euler (direct, β = 1), and with RATTLE?)",
      .hints = {"Of which order is each method?", "error ∝ hᵖ", "(h/2)ᵖ = hᵖ/2ᵖ, with p = 1 and p = 2"}};
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
      R"(Measure the *period* instead, from one passage through the lowest point to the next but one, and the answer
      changes: the errors are divided by @ and @. Symplectic Euler follows the orbit of a method of order two, half a
      step behind it, and a clock that is always late by the same amount measures periods well. So the order depends
      on the error that you look at.)",
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
      R"(Two warnings. Errors of opposite sign cancel, so one point of a curve may lie much too far to the left: trust
      the slope of many points, not one of them. And every curve ends, at rounding or at the uncertainty of the
      reference (dotted where it is in sight).)");
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
