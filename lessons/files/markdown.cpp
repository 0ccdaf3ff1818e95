#include "lessons/files/markdown.hpp"

#include <fmt/format.h>

#include <sstream>

#include "lessons/files/picture_writer.hpp"
#include "lessons/page/article_equations.hpp"
#include "lessons/page/claim_words.hpp"
#include "lessons/page/grading.hpp"
#include "lessons/page/lesson.hpp"

namespace byhand::course {
namespace {

/// Adds the blank line before a list without which Markdown continues the paragraph.
std::string with_separate_lists(const std::string& words) {
  std::string all;
  bool in_list = true;
  std::istringstream lines(words);
  for (std::string line; std::getline(lines, line);) {
    const bool item = line.starts_with("- ");
    if (item && !in_list) all += "\n";
    in_list = item || line.empty() || (in_list && !all.empty() && line.starts_with("  "));
    all += line + "\n";
  }
  return all;
}

/// Escapes the cell of a table.
std::string cell(const std::string& words) {
  std::string escaped;
  for (const char c : words) escaped += c == '|' ? "\\|" : c == '\n' ? " " : std::string(1, c);
  return escaped;
}

std::string row(const std::vector<std::string>& cells) {
  std::string line = "|";
  for (const std::string& words : cells) line += " " + cell(words) + " |";
  return line + "\n";
}

std::string rule(size_t columns) {
  std::string line = "|";
  for (size_t i = 0; i < columns; ++i) line += "---|";
  return line + "\n";
}

std::string details(const std::string& summary, const std::string& words) {
  return fmt::format("<details><summary>{}</summary>\n\n{}\n</details>\n", summary, words);
}

/// Picture and caption share a paragraph: pandoc prints the caption of a picture that is alone in one twice.
std::string picture(const std::string& caption, const std::string& path, const std::string& link,
                    const std::string& to) {
  std::string alternative;
  for (const char c : caption) alternative += c == '[' || c == ']' ? std::string("\\") + c : std::string(1, c);
  return fmt::format("![{}]({})  \n{}{}\n", alternative, path, caption,
                     link.empty() ? "" : fmt::format(" ([{}]({}))", link, to));
}

/// Writes the items of one page. Consecutive claims, or measures, share a table.
class PageWriter {
 public:
  PageWriter(std::string& page, FramesWanted frames) : page_(page), frames_(frames) {}

  void operator()(const Text& text) { paragraph(with_separate_lists(text.words)); }

  void operator()(const Equation& equation) {
    if (equation.number > 0)
      paragraph(fmt::format("$$\n{} \\tag{{{}}}\n$$\n", article_equation(equation.number).latex, equation.number));
    if (!equation.numbers.latex.empty()) paragraph(fmt::format("$$\n{}\n$$\n", equation.numbers.latex));
  }

  void operator()(const Excerpt& excerpt) {
    const std::string place =
        excerpt.line > 0 ? fmt::format("`{}`, line {}", excerpt.file, excerpt.line) : excerpt.file;
    paragraph(fmt::format("{}:\n\n```cpp\n{}```\n", place, excerpt.code));
  }

  void operator()(const course::Table& table) {
    std::string lines = row(table.head) + rule(table.head.size());
    for (const auto& cells : table.rows) lines += row(cells);
    paragraph(lines);
  }

  void operator()(const Derivation& derivation) {
    std::string lines;
    for (const DerivationLine& line : derivation.lines)
      lines += fmt::format("{}{}:\n\n$$\n{}\n$$\n", lines.empty() ? "" : "\n", line.why, line.latex);
    paragraph(details(derivation.title, lines));
  }

  void operator()(const Measure& measure) {
    table_row(Columns::measures, {"quantity", "value"}, {measure.quantity, quantity(measure.value, measure.unit)});
  }

  void operator()(const Figure& figure) {
    const bool has_data = !figure.data.empty() || !std::holds_alternative<Drawing>(figure.picture);
    paragraph(picture(figure.caption, figure_path(figure.name), has_data ? "data" : "", data_path(figure.name)));
  }

  void operator()(const Sequence& sequence) {
    if (frames_ == FramesWanted::none)
      paragraph(sequence.caption + "\n");
    else
      paragraph(picture(sequence.caption, strip_path(sequence.name),
                        frames_ == FramesWanted::all ? "all frames" : "the last frame",
                        frames_folder(sequence.name) + "/"));
  }

  void operator()(const Prediction& question) {
    std::string answer = fmt::format("**{}**. {}\n", printed_answer(question), question.right);
    for (const WrongAnswer& wrong : question.wrong)
      answer += fmt::format("\nNot {}: {}\n", quantity(wrong.value, question.unit, 4), wrong.reply);
    ask(question.ask, question.hints, answer);
  }

  void operator()(const Choice& question) {
    std::string words = question.ask + "\n\n", answer;
    int index = 0;
    for (const Option& option : question.options) {
      const bool right = index == question.answer;
      words += fmt::format("{}. {}\n", ++index, option.words);
      answer += fmt::format("{}{}{}. {}{} {}\n", index == 1 ? "" : "\n", right ? "**" : "Not ", index,
                            option.words, right ? "**." : ":", option.reply);
    }
    ask(words, question.hints, answer);
  }

  void operator()(const Claim& claim) {
    const std::string range = claim.range.words.empty() ? "" : fmt::format(" (for {})", claim.range.words);
    table_row(Columns::claims, {"claim", "measured", "expected", "according to", "verdict"},
              {claim.quantity + range, measurement(claim), expectation(claim), claim.source, verdict(claim)});
  }

 private:
  enum class Columns { none, measures, claims };

  void paragraph(const std::string& words) {
    page_ += "\n" + words;
    columns_ = Columns::none;
  }

  void table_row(Columns columns, const std::vector<std::string>& head, const std::vector<std::string>& cells) {
    if (columns_ != columns) page_ += "\n" + row(head) + rule(head.size());
    page_ += row(cells);
    columns_ = columns;
  }

  void ask(const std::string& words, const std::vector<std::string>& hints, const std::string& answer) {
    paragraph("**Before you read on.** " + words + (words.ends_with('\n') ? "" : "\n"));
    for (size_t i = 0; i < hints.size(); ++i)
      paragraph(details(hints.size() == 1 ? "Hint" : fmt::format("Hint {}", i + 1), hints[i] + "\n"));
    paragraph(details("Answer", answer));
  }

  std::string& page_;
  FramesWanted frames_;
  Columns columns_ = Columns::none;
};

std::string parameters(const Lesson& lesson) {
  if (lesson.parameters().empty()) return "";
  std::string lines = "\n" + row({"parameter", "value", "unit", "allowed", "meaning"}) + rule(5);
  for (const ParameterRecord& p : lesson.parameters())
    lines += row({"`" + p.name + "`", p.typed(p.value), p.unit, p.allowed(), p.meaning});
  return lines;
}

std::string closing(const Closing& closing) {
  std::string words;
  if (!closing.now_you_know.empty()) {
    words += "\n## What you now know\n\n";
    for (const std::string& known : closing.now_you_know) words += "- " + known + "\n";
  }
  if (!closing.tries.empty()) {
    words += "\n## To try\n";
    for (const Try& attempt : closing.tries)
      words += fmt::format("\n{}\n\n```sh\n{}\n```\n", attempt.what, attempt.command);
  }
  if (!closing.next.empty()) words += "\n## What comes next\n\n" + closing.next + "\n";
  return words;
}

}  // namespace

std::string markdown(const Lesson& lesson, const std::vector<RecordedStep>& steps, FramesWanted frames) {
  std::string page =
      fmt::format("# {}. {}\n\n{}\n", lesson.number(), lesson.about().title, lesson.about().summary);
  page += parameters(lesson);
  for (const auto& [step, recorded, reads] : steps) {
    page += fmt::format("\n## {} {}{}\n", step->label, step->title, step->deeper ? " *(deeper)*" : "");
    PageWriter write(page, frames);
    for (const Item& item : recorded.items()) std::visit(write, item);
  }
  return page + closing(lesson.closing());
}

}  // namespace byhand::course
