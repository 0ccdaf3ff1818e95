// Deeper: a block that slides and is held back by friction.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

void incline(Page& page) {
  const Problem problem("incline");
  const Survey& all = survey(page, problem, {Error::drift, Error::trajectory}, swing_most);
  page.text(
      R"(A block slides down a slope of @°, at @ m/s first; friction with μ = @ stops it. The velocity of a sliding block
      is exact, its position half a step late: the order is 1. One sweep solves the rows, so more sweeps gain nothing,
      but substeps do.)",
      problem["angle"], problem["speed"], problem["friction"]);
  show(page, "incline_trajectory", all, Error::trajectory);
  claim_first_order(page, problem, "s = ½ a t (t + h)");
}

}  // namespace byhand::accuracy
