// Deeper: the pendulums, with the errors that the core steps left out.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void five_errors(Page& page) {
  const Survey& simple = survey(page, Problem("pendulum", {{"length", 2}, {"mass", 3}}), Error::trajectory);
  page.text(
      R"(The simple pendulum again, by the force in its rod. λ of a step is an impulse, and over h it is the mean
      force of that step: a method that is late by half a step has the force of half a step ago.)");
  show(page, "pendulum_reaction", simple, Error::reaction);
  const Survey& compound =
      survey(page, Problem("compound_pendulum", {{"length", 2}, {"mass", 3}}), Error::trajectory);
  page.text(
      R"(A rod on a pin has two rows, and they are solved as one block; so a single sweep is exact and the curves
      by sweeps are upright lines: more sweeps cost and buy nothing.)");
  show(page, "compound", compound, {Error::trajectory, Error::drift, Error::energy, Error::reaction});
  const Survey& twice =
      survey(page, Problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}}), Error::trajectory);
  page.text(
      R"(The double pendulum is compared after @ s only: later it is chaos, and what is left of any two
      trajectories says nothing about a method.)",
      twice.problem.scene().time);
  show(page, "double", twice, {Error::trajectory, Error::drift, Error::energy, Error::reaction});
  for (const auto* one : {&simple, &compound, &twice}) claim_first_order(page, one->problem.scene().title, *one);
}

}  // namespace byhand::accuracy
