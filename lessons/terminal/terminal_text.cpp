#include "lessons/terminal/terminal_text.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/grading.hpp"
#include "lessons/terminal/text_chart.hpp"

namespace byhand::course {
namespace {

std::string formula(const std::string& block, const std::string& label, const Style& style) {
  std::string lines = folded(block, style, 6);
  if (!label.empty()) {
    const size_t first = std::min(lines.find('\n'), lines.size());
    const int room = std::max(style.width - 6, display_width(std::string_view(lines).substr(0, first)) + 2);
    lines = padded(std::string_view(lines).substr(0, first), room) + label + lines.substr(first);
  }
  return toned(lines.substr(0, lines.size() - 1), Tone::formula, style) + "\n";
}

const Measure* find(const Page& page, const Measure& like) {
  for (const Item& item : page.items())
    if (const auto* measure = std::get_if<Measure>(&item); measure && measure->quantity == like.quantity)
      return measure;
  return nullptr;
}

const Claim* find(const Page& page, const Claim& like) {
  for (const Item& item : page.items())
    if (const auto* claim = std::get_if<Claim>(&item); claim && claim->quantity == like.quantity) return claim;
  return nullptr;
}

std::string change(const std::string& what, const std::string& before, const std::string& now,
                   const Style& style) {
  const std::string lines = wrapped(fmt::format("{}: {} → {}", what, before, now), style, 2);
  return before == now ? toned(lines, Tone::quiet, style) : lines;
}

}  // namespace

std::string heading_text(const Lesson& lesson, const Style& style) {
  return "\n" + toned(fmt::format("{}. {}", lesson.number(), lesson.about().title), Tone::title, style) + "\n" +
         wrapped(lesson.about().summary, style);
}

std::string title_text(const Lesson& lesson, const Step& step, const Style& style) {
  const auto core =
      std::count_if(lesson.steps().begin(), lesson.steps().end(), [](const Step& s) { return !s.deeper; });
  const std::string title = step.deeper ? fmt::format("{}  {} (deeper)", step.label, step.title)
                                        : fmt::format("{}/{}  {}", step.label, core, step.title);
  if (style.plain) return "\n" + title + "\n";
  std::string rule;
  for (int i = 0; i < std::min(style.width, display_width(title)); ++i) rule += "─";
  return "\n" + toned(title, Tone::title, style) + "\n" + toned(rule, Tone::title, style) + "\n";
}

std::string closing_text(const Lesson& lesson, const Style& style) {
  const Closing& closing = lesson.closing();
  std::string words;
  if (!closing.now_you_know.empty()) {
    words += "\n" + toned("What you now know", Tone::title, style) + "\n";
    for (const std::string& known : closing.now_you_know) words += wrapped("- " + known, style);
  }
  if (!closing.tries.empty()) {
    words += "\n" + toned("To try", Tone::title, style) + "\n";
    for (const Try& attempt : closing.tries)
      words += wrapped("- " + attempt.what, style) + "    " + toned(attempt.command, Tone::code, style) + "\n";
  }
  if (!closing.next.empty())
    words += "\n" + toned("What comes next", Tone::title, style) + "\n" + wrapped(closing.next, style);
  return words;
}

std::string item_text(const Text& text, const Style& style) { return wrapped(text.words, style); }

std::string item_text(const Equation& equation, const Style& style) {
  std::string lines;
  if (equation.number > 0)
    lines += formula(article_equation(equation.number).plain, fmt::format("({})", equation.number), style);
  if (!equation.numbers.plain.empty()) lines += formula(equation.numbers.plain, "", style);
  return lines;
}

std::string item_text(const Excerpt& excerpt, const Style& style) {
  const std::string place = excerpt.line > 0 ? fmt::format("{}:{}", excerpt.file, excerpt.line) : excerpt.file;
  return toned("  " + place, Tone::quiet, style) + "\n" + toned(folded(excerpt.code, style, 4), Tone::code, style);
}

std::string item_text(const Table& table, const Style& style) {
  auto rows = table.rows;
  rows.insert(rows.begin(), table.head);
  for (std::string& cell : rows.front())
    if (!cell.empty()) cell = "**" + cell + "**";
  return course::table(rows, style, 2);
}

std::string item_text(const Derivation& derivation, const Style& style) {
  return wrapped(derivation.title + ": `why` shows it line by line.", style, 2);
}

std::string derivation_text(const Derivation& derivation, const Style& style) {
  std::string lines = wrapped("**" + derivation.title + "**", style, 2);
  for (const DerivationLine& line : derivation.lines)
    lines += formula(line.plain, "", style) + wrapped(line.why, style, 10);
  return lines;
}

std::string item_text(const Measure& measure, const Style& style) {
  return toned("  " + measure.quantity + " = ", Tone::quiet, style) + quantity(measure.value, measure.unit) + "\n";
}

std::string item_text(const Claim& claim, const Style& style) {
  const Tone tone = !claim.claimed() ? Tone::quiet : claim.holds() ? Tone::good : Tone::bad;
  const std::string sign = style.plain ? "-" : !claim.claimed() ? "–" : claim.holds() ? "✓" : "✗";
  std::string words = fmt::format("**{}**: measured {}, expected {} ({})", claim.quantity, measurement(claim),
                                  expectation(claim), claim.source);
  if (!claim.claimed())
    words += fmt::format("; not claimed here, only for {}", claim.range.words);
  else if (!claim.range.words.empty())
    words += fmt::format(", claimed for {}", claim.range.words);
  if (claim.is_false()) words += ": FALSE";
  const std::string lines = wrapped(words, style, 4);
  return "  " + toned(sign, tone, style) + lines.substr(3);
}

std::string item_text(const Prediction& question, const Style& style) {
  return toned("Predict", Tone::question, style) + "\n" + wrapped(question.ask, style, 2);
}

std::string item_text(const Choice& question, const Style& style) {
  std::string words = toned("Choose", Tone::question, style) + "\n" + wrapped(question.ask, style, 2);
  int index = 0;
  for (const Option& option : question.options)
    words += wrapped(fmt::format("**{}** {}", ++index, option.words), style, 4);
  return words;
}

std::string item_text(const Figure& figure, const Style& style) {
  const auto* chart = chart_of(figure);
  return chart ? text_chart(*chart, style) : "";
}

std::string caption_text(const std::string& caption, const std::string& path, const Style& style) {
  return wrapped(caption, style, 2) + (path.empty() ? "" : toned("  " + path, Tone::quiet, style) + "\n");
}

std::string answer_text(const Prediction& question, const Style& style) {
  return wrapped(fmt::format("**{}**. {}", printed_answer(question), question.right), style, 2);
}

std::string answer_text(const Choice& question, const Style& style) {
  const Option& right = question.options[static_cast<size_t>(question.answer)];
  return wrapped(fmt::format("**{} {}**. {}", question.answer + 1, right.words, right.reply), style, 2);
}

std::string changes_text(const Page& before, const Page& now, size_t items, const Style& style) {
  std::string lines;
  for (size_t i = 0; i < std::min(items, now.items().size()); ++i) {
    const Item& item = now.items()[i];
    if (const auto* measure = std::get_if<Measure>(&item)) {
      if (const Measure* const old = find(before, *measure))
        lines += change(measure->quantity, quantity(old->value, old->unit),
                        quantity(measure->value, measure->unit), style);
    }
    if (const auto* claim = std::get_if<Claim>(&item)) {
      if (const Claim* const old = find(before, *claim))
        lines += change(claim->quantity, fmt::format("{} ({})", measurement(*old), verdict(*old)),
                        fmt::format("{} ({})", measurement(*claim), verdict(*claim)), style);
    }
  }
  return lines;
}

std::string parameters_text(const Lesson& lesson) {
  if (lesson.parameters().empty()) return "This lesson has no parameters.\n";
  std::vector<std::vector<std::string>> rows = {{"name", "value", "default", "unit", "allowed", "meaning"}};
  for (const ParameterRecord& p : lesson.parameters())
    rows.push_back({p.name, p.typed(p.value), p.typed(p.initial), p.unit, p.allowed(), p.meaning});
  return table(rows);
}

}  // namespace byhand::course
