#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/lesson.hpp"
#include "lessons/tutor/options.hpp"
#include "lessons/tutor/typeset.hpp"

namespace byhand::tutor {

/// Claims in words, the same wherever they are shown.
std::string verdict(const Claim& claim);      // "holds", "false", "not claimed"
std::string expectation(const Claim& claim);  // "2.006 s ± 0.1 %", "≤ 1e-9 m"
std::string measurement(const Claim& claim);  // "2.007 s"
std::string quantity(double value, const std::string& unit, int digits = 6);

/// What a terminal says of a lesson. Each ends with a newline.
std::string say_heading(const Lesson& lesson, const Style& style);
std::string say_title(const Lesson& lesson, const Step& step, const Style& style);
std::string say_closing(const Lesson& lesson, const Style& style);
std::string say(const Text& text, const Style& style);
std::string say(const Equation& equation, const Style& style);
std::string say(const Excerpt& excerpt, const Style& style);
std::string say(const Measure& measure, const Style& style);
std::string say(const Claim& claim, const Style& style);
std::string say(const Prediction& question, const Style& style);
std::string say(const Choice& question, const Style& style);
/// A chart as text; of a picture nothing: the caption and the path are `say_caption`'s.
std::string say(const Figure& figure, const Style& style);
std::string say_caption(const std::string& caption, const std::string& path, const Style& style);

/// The answer of a question with its reason.
std::string say_answer(const Prediction& question, const Style& style);
std::string say_answer(const Choice& question, const Style& style);

/// Old and new of every measure and claim that both have, a line each; only those among the first `items`
/// items of `now`.
std::string say_changes(const Page& before, const Page& now, size_t items, const Style& style);

std::string say_parameters(const Lesson& lesson);

}  // namespace byhand::tutor
