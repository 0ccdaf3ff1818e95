#pragma once

#include <string>
#include <vector>

#include "lessons/page/items.hpp"

namespace byhand::course {

class Lesson;

struct Grade {
  bool right = false;
  bool understood = true;  // as an answer, right or wrong
  std::string reply;       // one sentence or two
};

/// A factor that people forget: {"h", 1/60}.
struct Factor {
  std::string name;
  double value;
};

/// ½, 2, 2π, g, and h and L where the lesson has them as parameters.
std::vector<Factor> forgettable_factors(const Lesson& lesson);

/// Grades a number (see read_typed) with or without a unit; without one it counts in the question's. A listed
/// wrong answer gets its own reply. So do a right value in a wrong unit, a wrong sign and a missing factor. Text
/// that is not a number gets a request to type one.
Grade grade(const Prediction& question, const std::string& typed, const std::vector<Factor>& forgettable = {});

/// Grades the number or the text of an option.
Grade grade(const Choice& question, const std::string& typed);

/// The answer as it is printed: with so many digits that it is accepted when typed back.
std::string printed_answer(const Prediction& question);

}  // namespace byhand::course
