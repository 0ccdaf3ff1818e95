// Deeper: a loop of bars.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void linkages(Page& page) {
  const Survey& all =
      survey(page, Problem("four_bar", {{"length", 2}, {"mass", 3}, {"coupler_mass", 3}}), Error::trajectory);
  page.text(
      R"(Three bars and four pins close a loop. The graph is a ring, so that sweeps have no beginning to start
      from, and the direct solve fills one block in; both are small. It swings as a simple pendulum of another
      length, which gives the reference in closed form.)");
  show(page, "four_bar", all, {Error::trajectory, Error::drift, Error::energy, Error::reaction});
  claim_first_order(page, "four-bar", all);
}

}  // namespace byhand::accuracy
