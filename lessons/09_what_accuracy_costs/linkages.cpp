// Deeper: a loop of bars.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "solver/exact/simple_pendulum.hpp"

namespace byhand::accuracy {

using namespace tutor;

void linkages(Page& page) {
  const Survey& all =
      survey(page, Problem("four_bar", {{"length", 2}, {"mass", 3}, {"coupler_mass", 3}}), Error::trajectory);
  page.text(
      "Three bars and four pins close a loop. The graph is a ring, so that sweeps have no beginning to start "
      "from, and "
      "the direct solve fills one block in; both are small. It swings as a simple pendulum of another length, "
      "which "
      "gives the reference in closed form.");
  show(page, "four_bar_trajectory", all, Error::trajectory);
  show(page, "four_bar_drift", all, Error::drift);
  show(page, "four_bar_energy", all, Error::energy);
  show(page, "four_bar_reaction", all, Error::reaction);
  const Series* direct = all.find("direct, substeps");
  page.claim({.quantity = "four-bar: order of the direct solve with substeps",
              .unit = "1",
              .expected = 1,
              .source = "symplectic Euler",
              .measured = fitted_order(direct->points, Error::trajectory),
              .tolerance = absolute(0.25)});
}

}  // namespace byhand::accuracy
