// Deeper: where the course displays each equation of the article.

#include "lessons/page/equation_places.hpp"

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/page/about.hpp"

namespace byhand::accuracy {

void equations(Page& page) {
  page.text(
      R"(The course was built from one article, R. Gaul, *Modelling and Solving Physical Constraints*, 2013. This is
      where it displays each of the article's equations for the first time, where the equation is derived or used:)");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < equation_places.size(); ++i) {
    const EquationPlace& place = equation_places[i];
    rows.push_back({say("(@)", i + 1), std::string(place.says),
                    say("@ @", place.lesson, contents().at(static_cast<std::size_t>(place.lesson - 1)).title),
                    std::string(place.step)});
  }
  page.table({"equation", "what it says", "lesson", "step"}, rows);
}

}  // namespace byhand::accuracy
