#include "lessons/site/reading.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace byhand::site {

Minutes reading_time(const Digest& lesson) {
  constexpr double words_a_minute = 90, minutes_a_question = 1.5;
  double core = 0, deeper = 0;
  for (const Digest::Step& step : lesson.steps) {
    const auto blanks = std::count(step.words.begin(), step.words.end(), ' ');
    (step.deeper ? deeper : core) +=
        static_cast<double>(blanks) / words_a_minute + minutes_a_question * step.questions;
  }
  const auto to_five = [](double minutes) { return 5 * static_cast<int>(std::lround(minutes / 5)); };
  return {to_five(core), to_five(deeper)};
}

std::string in_words(const Minutes& minutes) {
  const std::string core = fmt::format("about {} minutes", std::max(5, minutes.core));
  return minutes.deeper == 0 ? core : fmt::format("{}, {} more with the deeper steps", core, minutes.deeper);
}

}  // namespace byhand::site
