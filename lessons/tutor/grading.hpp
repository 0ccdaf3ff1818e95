#pragma once

#include <string>

#include "lessons/tutor/items.hpp"

namespace byhand::tutor {

struct Grade {
  bool right = false;
  bool understood = true;  // as an answer, right or wrong
  std::string reply;       // one sentence or two
};

/// Grades a number: "−0.42", "1/10", with or without the unit. A listed wrong answer gets its own reply; text that
/// is not a number gets a request to type one.
Grade grade(const Prediction& question, const std::string& typed);

/// Grades the number or the text of an option.
Grade grade(const Choice& question, const std::string& typed);

}  // namespace byhand::tutor
