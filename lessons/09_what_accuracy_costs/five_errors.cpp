// Deeper: the pendulums, with the errors that the core steps left out.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void five_errors(Page& page) {
  const Survey& simple = survey(page, Problem("pendulum", {{"length", 2}, {"mass", 3}}), Error::trajectory);
  page.text(
      "The simple pendulum again, by the force in its rod. λ of a step is an impulse, and over h it is the mean "
      "force of "
      "that step: a method that is late by half a step has the force of half a step ago.");
  show(page, "pendulum_reaction", simple, Error::reaction);
  const Survey& compound =
      survey(page, Problem("compound_pendulum", {{"length", 2}, {"mass", 3}}), Error::trajectory);
  page.text(
      "A rod on a pin has two rows, and they are solved as one block; so a single sweep is exact and the curves "
      "by "
      "sweeps are upright lines: more sweeps cost and buy nothing.");
  show(page, "compound_trajectory", compound, Error::trajectory);
  show(page, "compound_drift", compound, Error::drift);
  show(page, "compound_energy", compound, Error::energy);
  show(page, "compound_reaction", compound, Error::reaction);
  const Survey& twice =
      survey(page, Problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}}), Error::trajectory);
  page.text(
      "The double pendulum is compared after @ s only: later it is chaos, and what is left of any two "
      "trajectories "
      "says nothing about a method.",
      twice.problem.scene().time);
  show(page, "double_trajectory", twice, Error::trajectory);
  show(page, "double_drift", twice, Error::drift);
  show(page, "double_energy", twice, Error::energy);
  show(page, "double_reaction", twice, Error::reaction);
  for (const auto* one : {&simple, &compound, &twice}) {
    const Series* direct = one->find("direct, substeps");
    page.claim({.quantity = one->problem.scene().title + ": order of the direct solve with substeps",
                .unit = "1",
                .expected = 1,
                .source = "symplectic Euler",
                .measured = fitted_order(direct->points, Error::trajectory),
                .tolerance = absolute(0.25)});
  }
}

}  // namespace byhand::accuracy
