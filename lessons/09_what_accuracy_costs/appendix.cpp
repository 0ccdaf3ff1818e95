// Deeper: on request the charts of all errors of a scene and what takes long; where the article's equations are.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/page/about.hpp"
#include "lessons/page/equation_places.hpp"

namespace byhand::accuracy {
namespace {

/// Scenes, each with a chart of each of its errors, or a page of its own.
struct Chapter {
  std::string name;
  std::vector<Problem> problems = {};
  double most = 0;  // instructions per frame
  int runs = 0;
  std::string first_order = "";  // why the direct solve is of order 1, where that is claimed
  void (*page)(Page&) = nullptr;
};

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> all = [] {
    const std::string euler = "symplectic Euler";
    std::vector<Chapter> made{
        {"pendulum", {Problem("pendulum", {{"length", 2}, {"mass", 3}})}, swing_most, 300, euler},
        {"compound_pendulum",
         {Problem("compound_pendulum", {{"length", 2}, {"mass", 3}})},
         swing_most,
         300,
         euler},
        {"double_pendulum",
         {Problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}})},
         swing_most,
         300,
         euler},
        {"four_bar",
         {Problem("four_bar", {{"length", 2}, {"mass", 3}, {"coupler_mass", 3}})},
         swing_most,
         300,
         euler},
        {"spherical_pendulum",
         {Problem("spherical_pendulum", {{"length", 2}, {"mass", 3}})},
         swing_most,
         300,
         euler},
        {"top", {Problem("top")}, swing_most, 300},
        {"incline", {Problem("incline")}, swing_most, 300, "s = ½ a t (t + h)"},
        {.name = "thousand_periods", .page = thousand_periods},
        {.name = "millimetre", .page = cost_to_a_millimetre}};
    for (const double links : {10, 50, 200}) {
      Chapter chains{say("chain_of_@", links), {}, 12000 * links, 60};
      for (const double end_mass : {1, 100, 1000})
        chains.problems.emplace_back("chain", Values{{"links", links}, {"end_mass", end_mass}});
      made.push_back(chains);
    }
    return made;
  }();
  return all;
}

/// Where the course displays each equation of the article for the first time.
void equations(Page& page) {
  page.text(
      R"(The course was built from one article, R. Gaul, *Modelling and Solving Physical Constraints*, 2013. The
      table says where it first shows each of the article's equations:)");
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < equation_places.size(); ++i) {
    const EquationPlace& place = equation_places[i];
    rows.push_back({say("(@)", i + 1), std::string(place.says),
                    say("@ @", place.lesson, contents().at(static_cast<std::size_t>(place.lesson - 1)).title),
                    std::string(place.step)});
  }
  page.table({"equation", "what it says", "lesson", "step"}, rows);
}

}  // namespace

std::vector<std::string> appendix_scenes() {
  std::vector<std::string> names{"none"};
  for (const Chapter& chapter : chapters()) names.push_back(chapter.name);
  return names;
}

void appendix(Page& page, const std::string& scene) {
  std::string names;
  for (const std::string& name : appendix_scenes())
    if (name != "none") names += (names.empty() ? "`" : ", `") + name + "`";
  page.text(
      R"(The charts of all errors of a scene are drawn on request, by `--set appendix=` and one of @.
      `thousand_periods` shows the energy of a pendulum over that time. `millimetre` shows the cost of a drift of a
      millimetre for up to 1000 links and a mass ratio of up to a million; it takes minutes.)",
      names);
  for (const Chapter& chapter : chapters()) {
    if (chapter.name != scene) continue;
    if (chapter.page) chapter.page(page);
    for (std::size_t i = 0; i < chapter.problems.size(); ++i) {
      const Problem& problem = chapter.problems[i];
      std::vector<Error> watched = problem.scene().keeps_spin ? spin_errors : swing_errors;
      if (!has(problem.scene(), Error::energy)) std::erase(watched, Error::energy);
      const Survey& all = survey(page, problem, watched, chapter.most, chapter.runs);
      for (const Error error : watched)
        show(page, say("appendix_@_@_@", chapter.name, i + 1, std::string(name_of(error))), all, error);
      if (!chapter.first_order.empty()) claim_first_order(page, problem, chapter.first_order);
    }
  }
  equations(page);
}

}  // namespace byhand::accuracy
