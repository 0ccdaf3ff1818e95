#include "lessons/tutor/dialogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <optional>
#include <stdexcept>

#include "lessons/tutor/check.hpp"
#include "lessons/tutor/command.hpp"
#include "lessons/tutor/grading.hpp"
#include "lessons/tutor/keyboard.hpp"
#include "lessons/tutor/place.hpp"
#include "lessons/tutor/speech.hpp"
#include "lessons/tutor/stage.hpp"
#include "lessons/tutor/straight.hpp"
#include "lessons/tutor/studio.hpp"
#include "lessons/tutor/told.hpp"

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
        studio_(studio_of(lesson, options)),
        style_(terminal_style()),
        stage_(studio_, keyboard_, style_) {}

  int run();

 private:
  /// How a talk about one item, or about the end of a step, goes on.
  enum class Move { go_on, answered, again, back, deeper, quit };

  Move visit(size_t step);
  Move talk(size_t item);
  std::optional<Move> obey(const Command& command, size_t item);
  std::optional<Move> answer(const std::string& words, size_t item);
  void change(const Command& command, size_t item);
  void help() const;
  void prompt(size_t item) const;
  bool goes_deeper() const { return at_ + 1 < lesson_.steps().size() && lesson_.steps()[at_ + 1].deeper; }
  size_t next_core(size_t step) const;
  size_t before(size_t step) const;
  int finish();
  void leave() const;

  template <class... T>
  void tell_reader(fmt::format_string<T...> words, T&&... values) const {
    fmt::print("{}", wrapped(fmt::format(words, std::forward<T>(values)...), style_, 2));
  }

  Lesson& lesson_;
  const Options& options_;
  Keyboard keyboard_;
  Studio studio_;
  Style style_;
  Stage stage_;
  size_t at_ = 0;  // the step
  Page page_;      // of that step
  bool remembered_ = true;
};

int Dialogue::run() {
  const auto& steps = lesson_.steps();
  Place place = read_place(lesson_.about().slug);
  const std::string start = options_.step.empty() ? place.step : options_.step;
  const auto found =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.label == start; });
  fmt::print("{}", say_heading(lesson_, style_));
  if (found != steps.end() && found != steps.begin()) {
    at_ = static_cast<size_t>(found - steps.begin());
    if (options_.step.empty())
      fmt::print("{}", toned("You stopped here last time; b goes back.\n", Tone::quiet, style_));
  }
  while (at_ < steps.size()) {
    place.step = steps[at_].label;
    remembered_ = keep_place(lesson_.about().slug, place);
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

/// From a core step to the one before it; from a deeper step to what it went deeper from.
size_t Dialogue::before(size_t step) const {
  const bool deeper = lesson_.steps()[step].deeper;
  do --step;
  while (!deeper && lesson_.steps()[step].deeper);
  return step;
}

Dialogue::Move Dialogue::visit(size_t step) {
  page_ = tell(lesson_, lesson_.steps()[step], options_.quiet).page;
  fmt::print("{}", say_title(lesson_, lesson_.steps()[step], style_));
  for (size_t item = 0;;) {
    const bool ended = item >= page_.items().size();
    if (!ended) {
      fmt::print("\n");
      stage_.show(page_.items()[item]);
      if (!is_question(page_.items()[item])) {
        ++item;
        continue;
      }
    }
    const Move move = talk(item);
    if (move == Move::again) {
      item = 0;
      fmt::print("{}", say_title(lesson_, lesson_.steps()[step], style_));
    } else if (!ended && (move == Move::go_on || move == Move::answered)) {
      ++item;
    } else {
      return move;
    }
  }
}

void Dialogue::prompt(size_t item) const {
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

Dialogue::Move Dialogue::talk(size_t item) {
  while (true) {
    prompt(item);
    const auto line = keyboard_.line();
    if (!line) {
      fmt::print("\n");
      return Move::quit;
    }
    const size_t items = page_.items().size();
    if (const auto move = obey(understand(lesson_, *line), item)) return *move;
    if (page_.items().size() != items) return Move::again;
  }
}

/// Nothing: the talk goes on where it is.
std::optional<Dialogue::Move> Dialogue::obey(const Command& command, size_t item) {
  const bool asking = item < page_.items().size();
  switch (command.kind) {
    case Command::Kind::go_on: return Move::go_on;
    case Command::Kind::again: return Move::again;
    case Command::Kind::quit: return Move::quit;
    case Command::Kind::back:
      if (at_ > 0) return Move::back;
      tell_reader("This is where the lesson begins.");
      break;
    case Command::Kind::deeper:
      if (goes_deeper()) return Move::deeper;
      tell_reader("Nothing goes deeper here.");
      break;
    case Command::Kind::hint: {
      const std::string hint =
          asking ? of_question(page_.items()[item], [](const auto& q) { return q.hint; }) : "";
      tell_reader("{}", !asking ? "There is no question here." : hint.empty() ? "This one has no hint." : hint);
      break;
    }
    case Command::Kind::show:
      if (asking) {
        fmt::print("{}", of_question(page_.items()[item], [&](const auto& q) { return say_answer(q, style_); }));
        return Move::answered;
      }
      tell_reader("There is no question here.");
      break;
    case Command::Kind::help: help(); break;
    case Command::Kind::look_up:
      for (const ParameterRecord& p : lesson_.parameters())
        if (p.name == command.name) tell_reader("{}", p.described(p.value));
      break;
    case Command::Kind::set: change(command, item); break;
    case Command::Kind::words: return answer(command.value, item);
  }
  return std::nullopt;
}

std::optional<Dialogue::Move> Dialogue::answer(const std::string& words, size_t item) {
  if (item >= page_.items().size()) {
    tell_reader("There is no question here, and no key or parameter is called \"{}\": `?` lists them.", words);
    return std::nullopt;
  }
  const Grade given =
      of_question(page_.items()[item], [&](const auto& question) { return grade(question, words); });
  const std::string sign = given.right ? toned("Yes.", Tone::good, style_) : "";
  fmt::print("{}", wrapped(sign + (sign.empty() ? "" : " ") + given.reply, style_, 2));
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
    now = tell(lesson_, lesson_.steps()[at_], options_.quiet).page;
  } catch (const std::invalid_argument& bad) {
    lesson_.set(command.name, old);
    tell_reader("{}. Nothing was changed.", bad.what());
    return;
  }
  fmt::print("\n{}\n", toned(fmt::format("  {}: {} → {}", command.name, old, value()), Tone::question, style_));
  fmt::print("{}", say_changes(page_, *now, item, style_));
  page_ = std::move(*now);
  if (item > page_.items().size()) return;
  for (size_t i = 0; i < item; ++i) {
    const Item& seen = page_.items()[i];
    if (std::holds_alternative<Figure>(seen) || std::holds_alternative<Sequence>(seen)) stage_.show(seen);
  }
  if (item < page_.items().size() && is_question(page_.items()[item])) stage_.show(page_.items()[item]);
}

void Dialogue::help() const {
  fmt::print("{}", table({{"Enter", "go on"},
                          {"b", "back to the step before"},
                          {"d", "deeper, where a step offers it"},
                          {"h", "a hint for the question"},
                          {"s", "show the answer"},
                          {"r", "read this step again"},
                          {"q", "leave; the lesson remembers where"}},
                         2));
  if (lesson_.parameters().empty()) return;
  const ParameterRecord& first = lesson_.parameters().front();
  tell_reader(
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
             toned(remembered_ ? "Until next time: the lesson goes on where you stopped.\n"
                               : "Until next time (the place could not be kept: no writable state folder).\n",
                   Tone::quiet, style_));
}

/// The end: the page is written for the whole lesson, deeper steps included, with the parameters as they now
/// are.
int Dialogue::finish() {
  fmt::print("{}", say_closing(lesson_, style_));
  keep_place(lesson_.about().slug, {"", true});
  std::fflush(stdout);
  std::vector<Told> told;
  for (const Step& step : lesson_.steps()) {
    told.push_back(tell(lesson_, step, options_.quiet));
    write_pictures(told.back().page, studio_);
  }
  require_whole(told);
  publish(lesson_, told, options_, studio_);
  const std::string wrong = false_claims(lesson_, told);
  fmt::print(stderr, "{}", wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int run_dialogue(Lesson& lesson, const Options& options) { return Dialogue(lesson, options).run(); }

}  // namespace byhand::tutor
