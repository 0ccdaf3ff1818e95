#include "lessons/page/page.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <memory>
#include <optional>

#include "lessons/page/article_equations.hpp"
#include "lessons/page/error.hpp"
#include "lessons/page/excerpt.hpp"

namespace byhand::course {
namespace {

void require_file_name(const std::string& name) {
  if (name.empty() || name.find_first_not_of("abcdefghijklmnopqrstuvwxyz0123456789_") != std::string::npos)
    throw LessonError(fmt::format("\"{}\" cannot name a picture: use a-z, 0-9 and _", name));
}

/// Takes the line breaks of the source out of an item's prose.
struct Unwrap {
  void operator()(Text& text) const { unwrap(text.words); }
  void operator()(Figure& figure) const { unwrap(figure.caption); }
  void operator()(Sequence& sequence) const { unwrap(sequence.caption); }
  void operator()(Prediction& question) const {
    unwrap(question.ask);
    for (std::string& hint : question.hints) unwrap(hint);
    unwrap(question.right);
    for (WrongAnswer& wrong : question.wrong) unwrap(wrong.reply);
  }
  void operator()(Choice& question) const {
    unwrap(question.ask);
    for (std::string& hint : question.hints) unwrap(hint);
    for (Option& option : question.options) {
      unwrap(option.words);
      unwrap(option.reply);
    }
  }
  void operator()(Table& table) const {
    for (std::string& cell : table.head) unwrap(cell);
    for (auto& row : table.rows)
      for (std::string& cell : row) unwrap(cell);
  }
  void operator()(Derivation& derivation) const {
    unwrap(derivation.title);
    for (DerivationLine& line : derivation.lines) unwrap(line.why);
  }
  void operator()(auto&) const {}  // formulas and excerpts keep their lines

 private:
  static void unwrap(std::string& prose) { prose = unwrapped(prose); }
};

constexpr std::string_view quote = "“", unquote = "”";

std::string_view sentence_of(const Claim& verdict) {
  std::string_view sentence = verdict.quantity;
  sentence.remove_prefix(quote.size());
  sentence.remove_suffix(unquote.size());
  return sentence;
}

}  // namespace

void Page::add(Item item) {
  std::visit(Unwrap{}, item);
  if (const auto* text = std::get_if<Text>(&item)) {
    // As their sentences stand in it: the arguments of a call are computed in any order.
    const auto place = [&](const Claim& verdict) { return text->words.find(sentence_of(verdict)); };
    std::ranges::stable_sort(verdicts_, {}, place);
  }
  items_.push_back(std::move(item));
  for (Claim& verdict : verdicts_) items_.emplace_back(std::move(verdict));
  verdicts_.clear();
}

void Page::equation(int number) { equation(number, Formula{}); }

void Page::equation(int number, Formula numbers) {
  article_equation(number);
  add(Equation{number, std::move(numbers)});
}

void Page::excerpt(const std::string& file, const std::string& tag) {
  add(read_excerpt(BYHAND_SOURCE_DIR, file, tag));
}

void Page::table(std::vector<std::string> head, std::vector<std::vector<std::string>> rows) {
  for (const auto& row : rows)
    if (row.size() != head.size())
      throw LessonError(fmt::format("the table of \"{}\" has {} columns, but a row of {} cells",
                                    head.empty() ? "" : head.front(), head.size(), row.size()));
  add(Table{std::move(head), std::move(rows)});
}

void Page::derivation(std::string title, std::vector<DerivationLine> lines) {
  if (lines.empty()) throw LessonError(fmt::format("the derivation \"{}\" has no lines", title));
  for (const DerivationLine& line : lines)
    if (line.why.empty() || line.plain.empty() || line.latex.empty())
      throw LessonError(fmt::format("the derivation \"{}\" has a line \"{}\" without its reason or its formula",
                                    title, line.plain + line.latex + line.why));
  add(Derivation{std::move(title), std::move(lines)});
}

void Page::measure(std::string quantity, double value, std::string unit) {
  add(Measure{std::move(quantity), value, std::move(unit)});
}

void Page::figure(std::string name, std::string caption, renderer::Chart chart, std::string data) {
  require_file_name(name);
  add(Figure{std::move(name), std::move(caption), std::move(chart), std::move(data)});
}

void Page::figure(std::string name, std::string caption, Drawing draw, std::string data) {
  require_file_name(name);
  add(Figure{std::move(name), std::move(caption), std::move(draw), std::move(data)});
}

void Page::clocked(std::string name, std::string caption, std::function<renderer::Chart()> measure) {
  require_file_name(name);
  auto measured = std::make_shared<std::optional<renderer::Chart>>();
  auto once = [measure = std::move(measure), measured]() -> const renderer::Chart& {
    if (!*measured) *measured = measure();
    return **measured;
  };
  add(Figure{std::move(name), std::move(caption), TimedChart{std::move(once)}});
}

void Page::sequence(std::string name, std::string caption, std::variant<Seconds, Frames> length,
                    FrameDrawing draw) {
  require_file_name(name);
  add(Sequence{std::move(name), std::move(caption), length, std::move(draw)});
}

void Page::predict(Prediction question) {
  if (!(question.tolerance > 0))
    throw LessonError(fmt::format("\"{}\" needs a tolerance above zero", question.ask));
  add(std::move(question));
}

void Page::choose(Choice question) {
  if (question.answer < 0 || question.answer >= static_cast<int>(question.options.size()))
    throw LessonError(fmt::format("\"{}\" has no option {}", question.ask, question.answer));
  add(std::move(question));
}

void Page::claim(Claim claim) {
  if (claim.source.empty())
    throw LessonError(
        fmt::format("the claim \"{}\" does not say where its expectation comes from", claim.quantity));
  if (!claim.claimed() && claim.range.words.empty())
    throw LessonError(
        fmt::format("the claim \"{}\" is not claimed here, but does not say where it is", claim.quantity));
  add(std::move(claim));
}

void Page::claim(std::string quantity, double measured, std::string unit, Expected expected, Condition range) {
  claim({.quantity = std::move(quantity),
         .unit = std::move(unit),
         .expected = expected.value,
         .source = std::move(expected.source),
         .measured = measured,
         .tolerance = expected.tolerance,
         .range = std::move(range)});
}

std::string Page::verdict(const std::vector<Judgement>& sentences) {
  for (const auto& [when, say, law] : sentences)
    if (when.found.empty())
      throw LessonError(fmt::format("the verdict \"{}\" does not name the number that it judges", say));
  for (const auto& [when, say, law] : sentences) {
    if (!when.met) continue;
    const Condition judged = both(when, law);
    const std::string sentence = unwrapped(say);
    verdicts_.push_back(
        {.quantity = fmt::format("{}{}{}", quote, sentence, unquote), .source = "the sentence", .judged = judged});
    return sentence;
  }
  return {};
}

}  // namespace byhand::course
