#pragma once

#include <string>

#include "lessons/tutor/items.hpp"

namespace byhand::tutor {

struct Grade {
  bool right = false;
  std::string reply;  // one sentence or two
};

/// Grades what was typed: a number with its sign ("−0.42", "1/10", with or without the unit). A wrong answer
/// that people give gets its own reply. Words that are no number are not wrong: they are asked for again
/// (`right` false).
Grade grade(const Prediction& question, const std::string& typed);

/// Grades the number of an option or its words.
Grade grade(const Choice& question, const std::string& typed);

}  // namespace byhand::tutor
