// Deeper: a loop of bars.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

void linkages(Page& page) {
  const Survey& all = survey(page, Problem("four_bar", {{"length", 2}, {"mass", 3}, {"coupler_mass", 3}}),
                             swing_errors, swing_most);
  page.text(
      R"(Three bars and four pins form a loop. Sweeps have no end of a chain to begin at, and the factor of the direct
      solve gets one more block. The linkage swings as a simple pendulum of another length, so its reference is a closed
      form.)");
  show(page, "four_bar_reaction", all, Error::reaction);
  claim_first_order(page, all.problem);
}

}  // namespace byhand::accuracy
