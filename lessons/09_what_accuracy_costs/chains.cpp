// Deeper: chains of 10, 50 and 200 links with end masses of 1, 100 and 1000.

#include <cmath>

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {

using namespace tutor;

void chains(Page& page) {
  const Survey& solved = survey(page, Problem("chain", {{"links", 10}}), Error::algebraic, 1e6);
  page.text(
      R"(First the solver alone: how far the velocities after one step of ten links are from the exact solution of the
      same rows. This is the only error that more sweeps reduce to rounding. Conjugate sweeps need the fewest; a direct
      solve has rounding only.)");
  show(page, "chain_10_algebraic", solved, Error::algebraic);
  page.text(
      R"(Now one parameter of the scene at a time: 10, 50 and 200 links, each with an end mass of 1, 100 and 1000. By the
      laws of lesson 8 the sweeps needed grow with the length and with the end mass. The cost of the direct solve grows
      with the length alone, by a fixed price for each link, and the number of substeps that it needs is set by
      T·h²/(m·l) < 1.)");
  for (const int links : {10, 50, 200})
    for (const int end_mass : {1, 100, 1000}) {
      const Problem problem("chain",
                            {{"links", static_cast<double>(links)}, {"end_mass", static_cast<double>(end_mass)}});
      const Survey& all = survey(page, problem, Error::drift, links == 50 && end_mass == 100 ? 1e7 : 1.5e6);
      const std::string name = say("chain_@_@", links, end_mass);
      if (links != 50 || end_mass != 100) show(page, name + "_drift", all, Error::drift);
      show(page, name + "_trajectory", all, Error::trajectory);
      if (end_mass == 100) {
        show(page, name + "_reaction", all, Error::reaction);
        show(page, name + "_energy", all, Error::energy);
      }
      const Series* direct = all.find("direct, substeps");
      double least = INFINITY;
      for (const byhand::Point& point : direct->points)
        if (point.has(Error::drift)) least = std::min(least, point[Error::drift]);
      page.claim({.quantity = say("@ links, end mass @: least drift of the direct solve", links, end_mass),
                  .unit = "m",
                  .expected = 1e-3 * links,
                  .source = "a thousandth of its length, with any end mass",
                  .measured = least,
                  .tolerance = at_most()});
    }
}

}  // namespace byhand::accuracy
