// Deeper: what goes round in space.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

void in_space(Page& page) {
  const Survey& pendulum =
      survey(page, Problem("spherical_pendulum", {{"length", 2}, {"mass", 3}}), spin_errors, swing_most);
  page.text(
      R"(For motion about the vertical there is one error more: the angular momentum about it, which neither the weight
      nor the rod can change. A method whose impulses act along the rod, at the place where the rod then is, keeps it to
      rounding, at the left edge. A method that moves positions back acts along another
      line, and does not keep it.)");
  show(page, "spherical", pendulum, {Error::trajectory, Error::momentum});
  const Survey& top = survey(page, Problem("top"), spin_errors, swing_most);
  page.text(
      R"(A top that precesses steadily on its tip turns by @ rad a frame about its own axis. A step that is too long for
      the spin gets the force on the tip wrong, however well its rows are solved.)",
      Value(top.problem["spin"] * frame, 2));
  show(page, "top_trajectory", top, Error::trajectory);
  claim_first_order(page, pendulum.problem);
}

}  // namespace byhand::accuracy
