// Deeper: a block that slides and is held back by friction.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void incline(Page& page) {
  const Problem problem("incline");
  const Survey& all = survey(page, problem, Error::trajectory);
  page.text(
      R"(A block sets out down a slope of @° at @ m/s; friction, μ = @, stops it. Sliding is exact in velocity and
      late by half a step in position, so the order is 1 and a single sweep will do: sweeps buy nothing here,
      substeps do.)",
      problem["angle"], problem["speed"], problem["friction"]);
  show(page, "incline", all, {Error::trajectory, Error::drift});
  claim_first_order(page, "incline", all, "s = ½ a t (t + h)");
}

}  // namespace byhand::accuracy
