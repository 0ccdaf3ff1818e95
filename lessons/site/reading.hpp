#pragma once

#include "lessons/site/digest.hpp"

namespace byhand::site {

/// Minutes that a student takes for the core and for the deeper steps of a lesson, to five: words at the pace of a
/// text with formulas, and time to think at each question.
struct Minutes {
  int core = 0, deeper = 0;
};
Minutes reading_time(const Digest& lesson);

/// "about 40 minutes, 25 more with the deeper steps"
std::string in_words(const Minutes& minutes);

}  // namespace byhand::site
