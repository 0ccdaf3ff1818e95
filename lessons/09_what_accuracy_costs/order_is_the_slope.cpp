// Step 2: how to read a work–precision chart.

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/09_what_accuracy_costs/walking_down.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::accuracy {
namespace {

/// By how much halving the step divides an error, from four steps a frame on.
template <class ErrorOf>
double gain(const ErrorOf& error) {
  return std::abs(error(4) / error(8));
}

double gain_in_place(const Problem& problem, const Family& family, Knobs knobs) {
  return gain([&](int steps) {
    knobs.substeps = steps;
    return measure(problem, family, knobs)[Error::trajectory];
  });
}
double gain_in_period(const Problem& problem, const Family& family, Knobs knobs) {
  const SimplePendulum exact(problem["angle"] * std::numbers::pi / 180, problem["length"], problem["gravity"]);
  return gain([&](int steps) {
    knobs.substeps = steps;
    return period(problem, family.setting(knobs)) - exact.period();
  });
}

}  // namespace

void order_is_the_slope(Page& page) {
  const Problem problem("pendulum", {{"length", 2}, {"mass", 3}});
  page.text(
      R"(A bob of @ kg on a rod of @ m is released level. Elliptic functions give its angle after a second to machine
      precision. Each curve below is one method with all its choices (substeps, sweeps, cure of drift and its strength,
      relaxation): at each cost, the least error of any of them. Error grows to the right and work upwards, so **down
      and left is good**. A run counts only if it holds the scene together: one in which the rod opens by a tenth of its
      length has failed, however cheap it is.)",
      problem["mass"], problem["length"]);
  const Survey& all = survey(page, problem, swing_errors, swing_most);
  show(page, "pendulum_trajectory", all, Error::trajectory, true);
  const Prices plane = prices_of("bobs", "Gauss–Seidel"), space = prices_of("links in space", "Gauss–Seidel");
  const auto projected = [](std::string_view kind) {
    return prices_of(kind, name_of(Cure::projection)).projected_row;
  };
  page.text(
      R"(Work is counted in processor *instructions*. Each method counts what it does: rows written, prepared
      and solved, bodies moved, contacts found, rows projected. Each of these has a price in instructions, measured for
      every method, cure and kind of row. For a bob in the plane, a row-solve of Gauss–Seidel, (17) and (20), takes @
      instructions; a row-solve of a projection, which writes C and J anew, takes @. For links in space the two take @
      and @. Counted like this, work is the same on every machine. The clock need
      not rank methods alike (step 6).)",
      Value(plane.row_solve, 2), Value(projected("bobs"), 2), Value(space.row_solve, 2),
      Value(projected("links in space"), 2));
  page.text(
      R"(Both axes are logarithmic, so a power law is a straight line. Where the error falls as hᵖ and the work grows as
      1/h, ten times the work moves a point by p decades to the left. That p is the *order* of the method.)");
  const Family &euler = family_named("direct"), &rattle = family_named("RATTLE");
  const Knobs whole{.cure = Cure::baumgarte, .strength = 1};
  const double first = gain_in_place(problem, euler, whole), second = gain_in_place(problem, rattle, {});
  const auto nearest = [](double ratio) { return std::log2(ratio) < 1.5 ? 2 : 4; };
  course::Choice question{
      .ask =
          R"(Halve the time step. By how much does that divide the error of the bob's *place* after a second, with
          symplectic Euler (direct, β = 1) and with RATTLE?)",
      .hints = {"Of which order is each method?", "error ∝ hᵖ", "(h/2)ᵖ = hᵖ/2ᵖ, with p = 1 and p = 2"}};
  struct Halved {
    int one, two;
    const char* reply;
  };
  for (const auto& [one, two, reply] :
       {Halved{2, 2, "RATTLE is of order 2, so it gains 2²."},
        Halved{2, 4,
               "Orders 1 and 2: on the chart, ten times the work moves a point one decade to the left, or two. "
               "The flatter the curve, the higher the order."},
        Halved{4, 4, "Symplectic Euler is of order 1 in place, so it gains 2¹."}}) {
    if (nearest(first) == one && nearest(second) == two)
      question.answer = static_cast<int>(question.options.size());
    question.options.push_back(
        {say("@ and @", one, two), say("@ Measured: @ and @.", reply, Value(first, 3), Value(second, 3))});
  }
  page.choose(std::move(question));
  const double first_period = gain_in_period(problem, euler, whole),
               second_period = gain_in_period(problem, rattle, {});
  walking_down(problem, page);
  page.text(
      R"(Measure the *period* instead, over one full swing, and the answer changes: the errors are divided by @ and @. Symplectic Euler follows the orbit of a method of order two, half a
      step behind it, and a clock that is always late by the same amount measures periods well. So the order depends
      on the error that you look at.)",
      Value(first_period, 3), Value(second_period, 3));
  page.claim("place after a second, symplectic Euler, h halved: error divided by", first, "1",
             is(2, "order 1", relative(0.05)));
  page.claim("the same, RATTLE", second, "1", is(4, "order 2", relative(0.05)));
  page.claim("period, symplectic Euler with β = 1, h halved: error divided by", first_period, "1",
             is(4, "conjugate to leapfrog, of order 2", relative(0.05)));
  page.claim("the same, RATTLE", second_period, "1", is(4, "order 2", relative(0.05)));
  page.text(
      R"(Two warnings. Errors of opposite sign cancel, so a single point of a curve may lie much too far to the left:
      trust the slope of many. And every curve ends, at rounding or at the uncertainty of the reference (dotted, where
      visible).)");
  struct Expected {
    const char *family, *source;
    double order;
  };
  std::string fits;
  for (const auto& [name, source, order] :
       {Expected{"RATTLE", "symmetric: 2", 2}, Expected{"implicit midpoint", "symmetric: 2", 2},
        Expected{"RK4", "four stages: 4", 4}}) {
    const auto fitted = fitted_order(refined(problem, name, {}, 32), Error::trajectory);
    page.claim(std::string("fitted order of ") + name, fitted ? fitted->slope : NAN, "1",
               is(order, source, absolute(0.2)));
    if (fitted)
      fits += say("\n- @: @ ± @", std::string(name), Value(fitted->slope, 3), Value(fitted->uncertainty, 1));
  }
  page.text("The orders, fitted to at least three halvings of the step, with their 95 % intervals:\n" + fits);
}

}  // namespace byhand::accuracy
