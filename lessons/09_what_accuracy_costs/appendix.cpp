// Deeper, on request: the charts of all errors of a scene, and the scaling of cost to its ends.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"

namespace byhand::accuracy {
namespace {

struct Chapter {
  std::string name;
  std::vector<Problem> problems;
  double most;  // instructions a frame
  int runs;
};

const std::vector<Chapter>& chapters() {
  static const std::vector<Chapter> all = [] {
    std::vector<Chapter> made{
        {"pendulum", {Problem("pendulum", {{"length", 2}, {"mass", 3}})}, swing_most, 300},
        {"compound_pendulum", {Problem("compound_pendulum", {{"length", 2}, {"mass", 3}})}, swing_most, 300},
        {"double_pendulum",
         {Problem("double_pendulum", {{"length", 2}, {"mass", 3}, {"end_mass", 3}})},
         swing_most,
         300},
        {"four_bar", {Problem("four_bar", {{"length", 2}, {"mass", 3}, {"coupler_mass", 3}})}, swing_most, 300},
        {"spherical_pendulum", {Problem("spherical_pendulum", {{"length", 2}, {"mass", 3}})}, swing_most, 300},
        {"top", {Problem("top")}, swing_most, 300}};
    for (const double links : {10, 50, 200}) {
      Chapter chains{say("chain_of_@", links), {}, 12000 * links, 60};
      for (const double end_mass : {1, 100, 1000})
        chains.problems.emplace_back("chain", Values{{"links", links}, {"end_mass", end_mass}});
      made.push_back(chains);
    }
    made.push_back({"millimetre", {}, 0, 0});
    made.push_back({"incline", {Problem("incline")}, swing_most, 300});
    return made;
  }();
  return all;
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
      R"(The charts of all errors of a scene are drawn on request, by `--set appendix=` and one of @. `millimetre` is the
      cost to a millimetre for up to 1000 links and a mass ratio of up to a million; it takes minutes.)",
      names);
  for (const Chapter& chapter : chapters()) {
    if (chapter.name != scene) continue;
    if (chapter.problems.empty())
      cost_to_a_millimetre(page, {10, 30, 100, 300, 1000}, {1, 10, 100, 1e3, 1e4, 1e5, 1e6},
                           "appendix_millimetre");
    for (std::size_t i = 0; i < chapter.problems.size(); ++i) {
      const Problem& problem = chapter.problems[i];
      std::vector<Error> watched = problem.scene().keeps_spin ? spin_errors : swing_errors;
      if (!has(problem.scene(), Error::energy)) std::erase(watched, Error::energy);
      const Survey& all = survey(page, problem, watched, chapter.most, chapter.runs);
      for (const Error error : watched)
        show(page, say("appendix_@_@_@", chapter.name, i + 1, std::string(name_of(error))), all, error);
    }
  }
}

}  // namespace byhand::accuracy
