// Deeper: a block that slides and is held back by friction.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void incline(Page& page) {
  const Problem problem("incline");
  const Survey& all = survey(page, problem, Error::trajectory);
  page.text(
      R"(A block slides down a slope of @°, at @ m/s first; friction with μ = @ stops it. The velocity of a sliding block
      is exact, its position half a step late: the order is 1. One sweep solves the rows, so more sweeps gain nothing,
      but substeps do.)",
      problem["angle"], problem["speed"], problem["friction"]);
  show(page, "incline", all, {Error::trajectory, Error::drift});
  claim_first_order(page, "incline", all, "s = ½ a t (t + h)");
}

}  // namespace byhand::accuracy
