#pragma once

#include <string>
#include <vector>

#include "lessons/files/options.hpp"
#include "lessons/page/claim_words.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/terminal/typeset.hpp"

namespace byhand::course {

/// A lesson as it is printed on a terminal. Each text ends with a newline.
std::string heading_text(const Lesson& lesson, const Style& style);
std::string title_text(const Lesson& lesson, const Step& step, const Style& style);
std::string closing_text(const Lesson& lesson, const Style& style);
std::string item_text(const Text& text, const Style& style);
std::string item_text(const Equation& equation, const Style& style);
std::string item_text(const Excerpt& excerpt, const Style& style);
std::string item_text(const Table& table, const Style& style);
/// Its title alone; derivation_text has its lines.
std::string item_text(const Derivation& derivation, const Style& style);
std::string derivation_text(const Derivation& derivation, const Style& style);
std::string item_text(const Measure& measure, const Style& style);
std::string item_text(const Claim& claim, const Style& style);
std::string item_text(const Prediction& question, const Style& style);
std::string item_text(const Choice& question, const Style& style);
/// A chart in characters; empty for a drawing. The caption is separate.
std::string item_text(const Figure& figure, const Style& style);
std::string caption_text(const std::string& caption, const std::string& path, const Style& style);

/// The right answer and its explanation.
std::string answer_text(const Prediction& question, const Style& style);
std::string answer_text(const Choice& question, const Style& style);

/// Old and new value of each measure and claim on both pages, a line each, among the first `items` items of `now`.
std::string changes_text(const Page& before, const Page& now, size_t items, const Style& style);

std::string parameters_text(const Lesson& lesson);

}  // namespace byhand::course
