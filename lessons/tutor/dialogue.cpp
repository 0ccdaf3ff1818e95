#include "lessons/tutor/dialogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "lessons/tutor/batch.hpp"
#include "lessons/tutor/bookmark.hpp"
#include "lessons/tutor/claim_table.hpp"
#include "lessons/tutor/command.hpp"
#include "lessons/tutor/grading.hpp"
#include "lessons/tutor/keyboard.hpp"
#include "lessons/tutor/picture_writer.hpp"
#include "lessons/tutor/recording.hpp"
#include "lessons/tutor/streams.hpp"
#include "lessons/tutor/terminal_text.hpp"
#include "lessons/tutor/terminal_view.hpp"

namespace byhand::tutor {
namespace {

bool is_question(const Item& item) {
  return std::holds_alternative<Prediction>(item) || std::holds_alternative<Choice>(item);
}

template <class Visitor>
auto of_question(const Item& item, const Visitor& visit) {
  return std::holds_alternative<Prediction>(item) ? visit(std::get<Prediction>(item))
                                                  : visit(std::get<Choice>(item));
}

class Dialogue {
 public:
  Dialogue(Lesson& lesson, const Options& options)
      : lesson_(lesson),
        options_(options),
        pictures_(lesson, options),
        style_(terminal_style()),
        view_(pictures_, keyboard_, style_) {}

  int run();

 private:
  /// What follows the prompt at an item or at the end of a step.
  enum class Move { next, answered, repeat, back, deeper, quit };

  Move visit(size_t step);
  Move prompt_until_done(size_t item);
  std::optional<Move> execute(const Command& command, size_t item);
  std::optional<Move> answer(const std::string& words, size_t item);
  void change(const Command& command, size_t item);
  void print_answer(size_t item) const;
  void hint(size_t item);
  void why(size_t item) const;
  void help() const;
  void print_prompt(size_t item) const;
  bool goes_deeper() const { return at_ + 1 < lesson_.steps().size() && lesson_.steps()[at_ + 1].deeper; }
  size_t next_core(size_t step) const;
  size_t before(size_t step) const;
  int finish();
  void leave() const;

  template <class... T>
  void print_line(fmt::format_string<T...> words, T&&... values) const {
    fmt::print("{}", wrapped(fmt::format(words, std::forward<T>(values)...), style_, 2));
  }

  Lesson& lesson_;
  const Options& options_;
  Keyboard keyboard_;
  PictureWriter pictures_;
  Style style_;
  TerminalView view_;
  size_t at_ = 0;           // index of the current step
  Page page_;               // of the current step
  size_t hints_given_ = 0;  // of the present question
  bool bookmark_saved_ = true;
};

int Dialogue::run() {
  const auto& steps = lesson_.steps();
  Bookmark bookmark = read_bookmark(lesson_.about().slug);
  const std::string start = options_.step.empty() ? bookmark.step : options_.step;
  const auto found =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.label == start; });
  fmt::print("{}", heading_text(lesson_, style_));
  if (found != steps.end() && found != steps.begin()) {
    at_ = static_cast<size_t>(found - steps.begin());
    if (options_.step.empty())
      fmt::print("{}", toned("You stopped here last time; b goes back.\n", Tone::quiet, style_));
  }
  while (at_ < steps.size()) {
    bookmark.step = steps[at_].label;
    bookmark_saved_ = save_bookmark(lesson_.about().slug, bookmark);
    switch (visit(at_)) {
      case Move::back: at_ = before(at_); break;
      case Move::deeper: ++at_; break;
      case Move::quit: leave(); return 0;
      default: at_ = next_core(at_);
    }
  }
  return finish();
}

size_t Dialogue::next_core(size_t step) const {
  do ++step;
  while (step < lesson_.steps().size() && lesson_.steps()[step].deeper);
  return step;
}

/// The previous core step; for a deeper step, the step before it.
size_t Dialogue::before(size_t step) const {
  const bool deeper = lesson_.steps()[step].deeper;
  do --step;
  while (!deeper && lesson_.steps()[step].deeper);
  return step;
}

Dialogue::Move Dialogue::visit(size_t step) {
  page_ = record_step(lesson_, lesson_.steps()[step], options_.quiet).page;
  fmt::print("{}", title_text(lesson_, lesson_.steps()[step], style_));
  for (size_t item = 0;;) {
    const bool ended = item >= page_.items().size();
    if (!ended) {
      fmt::print("\n");
      view_.show(page_.items()[item]);
      if (!is_question(page_.items()[item])) {
        ++item;
        continue;
      }
    }
    const Move move = prompt_until_done(item);
    if (move == Move::repeat) {
      item = 0;
      fmt::print("{}", title_text(lesson_, lesson_.steps()[step], style_));
    } else if (!ended && (move == Move::next || move == Move::answered)) {
      ++item;
    } else {
      return move;
    }
  }
}

void Dialogue::print_prompt(size_t item) const {
  std::string words;
  if (item < page_.items().size())
    words = "your answer (h hints, s shows, Enter goes on)";
  else
    words = fmt::format("Enter goes on{}{}, ? helps",
                        goes_deeper() ? ", d deeper: " + lesson_.steps()[at_ + 1].title : "",
                        at_ > 0 ? ", b back" : "");
  fmt::print("\n{}{} ", toned(words, Tone::quiet, style_), toned(" ▸", Tone::question, style_));
  std::fflush(stdout);
}

Dialogue::Move Dialogue::prompt_until_done(size_t item) {
  hints_given_ = 0;
  while (true) {
    print_prompt(item);
    const auto line = keyboard_.line();
    if (!line) {
      fmt::print("\n");
      return Move::quit;
    }
    const size_t items = page_.items().size();
    if (const auto move = execute(parse_command(lesson_, *line), item)) return *move;
    if (page_.items().size() != items) return Move::repeat;
  }
}

/// Returns nothing if the prompt stays at this item.
std::optional<Dialogue::Move> Dialogue::execute(const Command& command, size_t item) {
  const bool asking = item < page_.items().size();
  switch (command.kind) {
    case Command::Kind::next:
      if (asking) print_answer(item);
      return Move::next;
    case Command::Kind::repeat: return Move::repeat;
    case Command::Kind::quit: return Move::quit;
    case Command::Kind::back:
      if (at_ > 0) return Move::back;
      print_line("This is where the lesson begins.");
      break;
    case Command::Kind::deeper:
      if (goes_deeper()) return Move::deeper;
      print_line("Nothing goes deeper here.");
      break;
    case Command::Kind::hint: hint(item); break;
    case Command::Kind::why: why(item); break;
    case Command::Kind::show:
      if (asking) {
        print_answer(item);
        return Move::answered;
      }
      print_line("There is no question here.");
      break;
    case Command::Kind::help: help(); break;
    case Command::Kind::query:
      for (const ParameterRecord& p : lesson_.parameters())
        if (p.name == command.name) print_line("{}", p.described(p.value));
      break;
    case Command::Kind::set: change(command, item); break;
    case Command::Kind::answer: return answer(command.value, item);
  }
  return std::nullopt;
}

void Dialogue::print_answer(size_t item) const {
  fmt::print("{}", of_question(page_.items()[item], [&](const auto& q) { return answer_text(q, style_); }));
}

/// The next hint of the question; after the last one, the last one again.
void Dialogue::hint(size_t item) {
  if (item >= page_.items().size()) return print_line("There is no question here.");
  const auto hints = of_question(page_.items()[item], [](const auto& q) { return q.hints; });
  if (hints.empty()) return print_line("This question has no hint.");
  print_line("{}", hints[std::min(hints_given_, hints.size() - 1)]);
  ++hints_given_;
  if (hints_given_ < hints.size()) print_line("`hint` says more.");
}

/// The derivations above this item, line by line.
void Dialogue::why(size_t item) const {
  bool derived = false;
  for (size_t i = 0; i < std::min(item, page_.items().size()); ++i) {
    const auto* derivation = std::get_if<Derivation>(&page_.items()[i]);
    if (!derivation) continue;
    fmt::print("{}{}", derived ? "\n" : "", derivation_text(*derivation, style_));
    derived = true;
  }
  if (!derived) print_line("There is no derivation in this step so far.");
}

std::optional<Dialogue::Move> Dialogue::answer(const std::string& words, size_t item) {
  if (item >= page_.items().size()) {
    print_line("There is no question here, and no key or parameter is called \"{}\": `?` lists them.", words);
    return std::nullopt;
  }
  const Grade given =
      of_question(page_.items()[item], [&](const auto& question) { return grade(question, words); });
  const std::string sign = given.right        ? toned("Yes.", Tone::good, style_) + " "
                           : given.understood ? toned("No.", Tone::bad, style_) + " "
                                              : "";
  fmt::print("{}", wrapped(sign + given.reply, style_, 2));
  if (given.right) return Move::answered;
  return std::nullopt;
}

void Dialogue::change(const Command& command, size_t item) {
  const auto value = [&] {
    for (const ParameterRecord& p : lesson_.parameters())
      if (p.name == command.name) return p.typed(p.value);
    return std::string();
  };
  const std::string old = value();
  std::optional<Page> now;
  try {
    lesson_.set(command.name, command.value);
    now = record_step(lesson_, lesson_.steps()[at_], options_.quiet).page;
  } catch (const std::invalid_argument& bad) {
    lesson_.set(command.name, old);
    print_line("{}. Nothing was changed.", bad.what());
    return;
  }
  fmt::print("\n{}\n", toned(fmt::format("  {}: {} → {}", command.name, old, value()), Tone::question, style_));
  fmt::print("{}", changes_text(page_, *now, item, style_));
  page_ = std::move(*now);
  if (item > page_.items().size()) return;
  for (size_t i = 0; i < item; ++i) {
    const Item& seen = page_.items()[i];
    if (std::holds_alternative<Figure>(seen) || std::holds_alternative<Sequence>(seen)) view_.show(seen);
  }
  if (item < page_.items().size() && is_question(page_.items()[item])) view_.show(page_.items()[item]);
}

void Dialogue::help() const {
  fmt::print("{}", table({{"Enter", "go on"},
                          {"b", "back to the step before"},
                          {"d", "deeper, where a step offers it"},
                          {"h", "a hint for the question, the next one each time"},
                          {"why", "the derivation, line by line, where the text offers one"},
                          {"s", "show the answer"},
                          {"r", "read this step again"},
                          {"q", "leave; the lesson remembers where"}},
                         2));
  if (lesson_.parameters().empty()) return;
  const ParameterRecord& first = lesson_.parameters().front();
  print_line(
      "A name and a value change a parameter and run the step again: `{} {}`. A name alone tells what it "
      "is.",
      first.name, first.typed(first.value));
  std::vector<std::vector<std::string>> rows;
  for (const ParameterRecord& p : lesson_.parameters())
    rows.push_back(
        {p.name, p.typed(p.value) + (p.choices.empty() ? " [" + p.unit + "]" : ""), p.allowed(), p.meaning});
  fmt::print("{}", table(rows, 2));
}

void Dialogue::leave() const {
  fmt::print("{}",
             toned(bookmark_saved_ ? "Until next time: the lesson goes on where you stopped.\n"
                                   : "Until next time (the place could not be kept: no writable state folder).\n",
                   Tone::quiet, style_));
}

/// Writes the page of the whole lesson, deeper steps included, with the present parameters.
int Dialogue::finish() {
  fmt::print("{}", closing_text(lesson_, style_));
  std::fflush(stdout);
  std::vector<RecordedStep> steps;
  for (const Step& step : lesson_.steps()) {
    steps.push_back(record_step(lesson_, step, options_.quiet));
    write_pictures(steps.back().page, pictures_);
  }
  validate(steps);
  finish_output(lesson_, steps, options_, true, pictures_);
  save_bookmark(lesson_.about().slug, {"", true});
  const std::string wrong = false_claims(lesson_, steps);
  complain(wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int run_dialogue(Lesson& lesson, const Options& options) { return Dialogue(lesson, options).run(); }

}  // namespace byhand::tutor
