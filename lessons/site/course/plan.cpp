#include "lessons/site/course/plan.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numeric>

#include "lessons/files/atomic_file.hpp"
#include "lessons/page/words.hpp"

namespace byhand::site {
namespace {

namespace fs = std::filesystem;

constexpr int minutes_of_exercises = 15;

/// In minutes, before they are made to fit: words said aloud, a question with its discussion, a film shown twice,
/// a scene held by several people.
double weight(const Digest::Step& step) {
  const auto blanks = std::count(step.words.begin(), step.words.end(), ' ');
  return 1 + static_cast<double>(blanks) / 120 + 3 * step.questions + 2 * step.films + 4 * (step.scene ? 1 : 0);
}

std::string shown(const Digest::Step& step) {
  const std::string films = step.films == 0   ? ""
                            : step.films == 1 ? "the film"
                                              : fmt::format("{} films", step.films);
  if (!step.scene) return films.empty() ? "the formulas and figures" : films;
  return "the scene to hold" + (films.empty() ? "" : ", " + films);
}

}  // namespace

std::vector<PlannedPart> plan(const Digest& lesson, const std::vector<int>& exercises) {
  std::vector<PlannedPart> parts;
  std::vector<double> ends;  // of the parts, before they are made to fit
  double sum = 0;
  for (const Digest::Step& step : lesson.steps) {
    if (step.deeper) continue;
    const std::string ask = step.questions == 0 ? ""
                            : step.questions == 1
                                ? fmt::format("question {}.1", step.label)
                                : fmt::format("questions {0}.1 to {0}.{1}", step.label, step.questions);
    parts.push_back({0, step.label, shown(step), ask});
    ends.push_back(sum += weight(step));
  }
  const int for_steps = minutes_of_a_class - minutes_of_exercises;
  long begun = 0;
  for (std::size_t i = 0; i < parts.size(); ++i) {
    const long end = std::lround(for_steps * ends[i] / sum);
    parts[i].minutes = static_cast<int>(end - begun);
    begun = end;
  }
  std::vector<std::string> numbers;
  for (const int number : exercises) numbers.push_back(std::to_string(number));
  parts.push_back({minutes_of_a_class - static_cast<int>(begun), "",
                   exercises.empty()       ? "what the class wants to try"
                   : exercises.size() == 1 ? "exercise " + numbers.front()
                                           : fmt::format("exercises {}", fmt::join(numbers, ", ")),
                   ""});
  return parts;
}

std::map<int, std::vector<int>> exercises_by_lesson(const fs::path& practise) {
  std::map<int, std::vector<int>> all;
  if (!fs::is_directory(practise)) return all;
  constexpr std::string_view head = "\nLesson: ";
  for (const auto& entry : fs::directory_iterator(practise)) {
    const std::string task = course::read_whole(entry.path() / "task.md").value_or("");
    const auto at = task.find(head);
    if (at != std::string::npos)
      all[std::stoi(task.substr(at + head.size()))].push_back(std::stoi(entry.path().filename()));
  }
  for (auto& [lesson, numbers] : all) std::sort(numbers.begin(), numbers.end());
  return all;
}

}  // namespace byhand::site
