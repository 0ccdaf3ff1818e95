// Deeper: the pendulums, with the errors that the core steps left out.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

void five_errors(Page& page) {
  const Survey& simple = survey(page, Problem("pendulum", {{"length", 2}, {"mass", 3}}), swing_errors, swing_most);
  page.text(
      R"(The simple pendulum again, by the force in its rod. The λ of a step is an impulse; λ/h is the mean force of that
      step. So a method that is half a step late has the force of half a step ago.)");
  show(page, "pendulum_reaction", simple, Error::reaction);
  const Survey& compound =
      survey(page, Problem("compound_pendulum", {{"length", 2}, {"mass", 3}}), swing_errors, swing_most);
  page.text(
      R"(A rod on a pin has two rows, which are solved as one block. So one sweep is exact: more sweeps cost more and
      change nothing.)");
  show(page, "compound_trajectory", compound, Error::trajectory);
  const Survey& twice = survey(page, Problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}}),
                               swing_errors, swing_most);
  page.text(
      R"(The double pendulum is compared after @ s only. Its motion is chaotic: later any two trajectories differ, and
      that says nothing about a method.)",
      twice.problem.compared_at());
  show(page, "double_trajectory", twice, Error::trajectory);
  for (const auto* one : {&simple, &compound, &twice}) claim_first_order(page, one->problem);
}

}  // namespace byhand::accuracy
