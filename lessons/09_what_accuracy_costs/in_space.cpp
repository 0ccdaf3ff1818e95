// Deeper: what goes round in space.

#include "lessons/09_what_accuracy_costs/runs.hpp"
#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void in_space(Page& page) {
  const Survey& pendulum =
      survey(page, Problem("spherical_pendulum", {{"length", 2}, {"mass", 3}}), Error::trajectory);
  page.text(
      "Round the vertical there is one error more: the angular momentum about it, which neither the weight nor "
      "the rod "
      "can change. A method whose impulses act along the rod at one and the same place keeps it to rounding and "
      "has an "
      "upright line at the left edge; one that puts positions back does it along another line, and pays.");
  show(page, "spherical_trajectory", pendulum, Error::trajectory);
  show(page, "spherical_drift", pendulum, Error::drift);
  show(page, "spherical_energy", pendulum, Error::energy);
  show(page, "spherical_momentum", pendulum, Error::momentum);
  show(page, "spherical_reaction", pendulum, Error::reaction);
  const Survey& top = survey(page, Problem("top"), Error::trajectory);
  page.text(
      "A top that precesses steadily on its tip turns @ rad in a frame about its own axis: a step that cannot "
      "follow the "
      "spin gets the force on the tip wrong, however well the rows are solved.",
      Value(top.problem["spin"] * frame, 2));
  show(page, "top_trajectory", top, Error::trajectory);
  show(page, "top_drift", top, Error::drift);
  show(page, "top_energy", top, Error::energy);
  show(page, "top_momentum", top, Error::momentum);
  show(page, "top_reaction", top, Error::reaction);
  const Series* direct = pendulum.find("direct, substeps");
  page.claim({.quantity = "spherical pendulum: order of the direct solve with substeps",
              .unit = "1",
              .expected = 1,
              .source = "symplectic Euler",
              .measured = fitted_order(direct->points, Error::trajectory),
              .tolerance = absolute(0.25)});
}

}  // namespace byhand::accuracy
