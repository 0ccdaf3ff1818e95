#pragma once

#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// What the pages of the course need to know of a told lesson: its steps, the laws that it derives, how much there
/// is of what, and its words for the search.
struct Digest {
  struct Step {
    std::string label = {}, title = {};
    bool deeper = false;
    std::string words = {};  // prose, captions, questions, formulas, without marks
    int questions = 0, films = 0;
    bool scene = false;                   // there is one to hold
    std::vector<std::string> reads = {};  // names of its parameters
    std::vector<std::string> laws = {};   // titles of its derivations
  };

  std::string slug = {};
  std::vector<Step> steps = {};
  int claims = 0, figures = 0, films = 0;
};

Digest digest(const course::Lesson& lesson, const std::vector<course::RecordedStep>& steps);

}  // namespace byhand::site
