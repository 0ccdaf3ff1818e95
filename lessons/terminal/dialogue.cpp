#include "lessons/terminal/dialogue.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <memory>
#include <optional>
#include <stdexcept>

#include "lessons/files/bookmark.hpp"
#include "lessons/files/picture_writer.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/page/grading.hpp"
#include "lessons/page/recording.hpp"
#include "lessons/terminal/batch.hpp"
#include "lessons/terminal/claim_table.hpp"
#include "lessons/terminal/command.hpp"
#include "lessons/terminal/desktop.hpp"
#include "lessons/terminal/keyboard.hpp"
#include "lessons/terminal/screen.hpp"
#include "lessons/terminal/terminal_text.hpp"
#include "lessons/terminal/terminal_view.hpp"

namespace byhand::course {
namespace {

bool is_question(const Item& item) {
  return std::holds_alternative<Prediction>(item) || std::holds_alternative<Choice>(item);
}

bool is_picture(const Item& item) {
  return std::holds_alternative<Figure>(item) || std::holds_alternative<Sequence>(item);
}

const std::string& name_of(const Item& picture) {
  const auto* figure = std::get_if<Figure>(&picture);
  return figure ? figure->name : std::get<Sequence>(picture).name;
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
        screen_(keyboard_, options.plain),
        view_(pictures_, keyboard_, screen_) {
    keyboard_.on_tab([this](std::string_view before) { return completions(before); });
  }

  int run();

 private:
  /// What follows the prompt at an item or at the end of a step.
  enum class Move { next, answered, repeat, back, deeper, menu, quit };

  Move visit();
  Move prompt_until_done(size_t item);
  std::optional<Move> execute(const Command& command, size_t item);
  std::optional<Move> answer(const std::string& words, size_t item);
  void change(const Command& command, size_t item);
  void reset(size_t item);
  void compare(const Page& before, size_t item);
  void print_answer(size_t item);
  void hint(size_t item);
  void why(size_t item);
  void open(const std::string& name, size_t item);
  void list_parameters();
  void help();

  bool asks(size_t item) const { return item < page_->items().size(); }
  std::shared_ptr<const Item> item(size_t index) const { return item(page_, index); }
  static std::shared_ptr<const Item> item(const std::shared_ptr<const Page>& page, size_t index) {
    return {page, &page->items()[index]};
  }
  void record();
  void print_title();
  std::string what_can_be_typed(size_t item) const;
  std::string unit_asked_for(size_t item) const;
  std::vector<std::string> completions(std::string_view before) const;
  bool goes_deeper() const { return at_ + 1 < lesson_.steps().size() && lesson_.steps()[at_ + 1].deeper; }
  size_t next_core(size_t step) const;
  size_t before(size_t step) const;
  void take_up(const Bookmark& bookmark);
  void save(Bookmark bookmark);
  int finish();
  void leave();

  /// Prints a line of the dialogue itself, which may use emphasis.
  template <class... T>
  void say_line(fmt::format_string<T...> words, T&&... values) {
    screen_.show([line = fmt::format(words, std::forward<T>(values)...)](const Style& style) {
      return wrapped(line, style, 2);
    });
  }

  Lesson& lesson_;
  const Options& options_;
  Keyboard keyboard_;
  PictureWriter pictures_;
  Screen screen_;
  TerminalView view_;
  size_t at_ = 0;                     // index of the current step
  std::shared_ptr<const Page> page_;  // of the current step
  size_t hints_given_ = 0;            // of the present question
  bool bookmark_saved_ = true;
};

int Dialogue::run() {
  const Bookmark bookmark = read_bookmark(lesson_.about().slug);
  const auto& steps = lesson_.steps();
  const std::string start = options_.step.empty() ? bookmark.step : options_.step;
  const auto found =
      std::find_if(steps.begin(), steps.end(), [&](const Step& step) { return step.label == start; });
  screen_.show([this](const Style& style) { return heading_text(lesson_, style); });
  if (found != steps.end() && found != steps.begin()) {
    at_ = static_cast<size_t>(found - steps.begin());
    if (options_.step.empty()) say_line("You stopped here last time; `back` goes back.");
  }
  if (options_.set.empty()) take_up(bookmark);
  while (at_ < steps.size()) {
    save({.step = steps[at_].label, .finished = bookmark.finished});
    switch (visit()) {
      case Move::back: at_ = before(at_); break;
      case Move::deeper: ++at_; break;
      case Move::menu: return back_to_menu;
      case Move::quit: leave(); return 0;
      default: at_ = next_core(at_);
    }
  }
  return finish();
}

/// Sets the parameters as the reader left them.
void Dialogue::take_up(const Bookmark& bookmark) {
  std::string settings;
  for (const auto& [name, value] : bookmark.set) {
    try {
      lesson_.set(name, value);
      settings += fmt::format("{}{} = {}", settings.empty() ? "" : ", ", name, value);
    } catch (const std::invalid_argument&) {
      // The lesson has changed since then.
    }
  }
  if (!settings.empty()) say_line("As you left it: {}; `reset` brings the defaults back.", settings);
}

void Dialogue::save(Bookmark bookmark) {
  for (const ParameterRecord& p : lesson_.parameters())
    if (p.value != p.initial) bookmark.set.emplace_back(p.name, p.typed(p.value));
  bookmark_saved_ = save_bookmark(lesson_.about().slug, bookmark);
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

void Dialogue::record() {
  page_ = std::make_shared<const Page>(record_step(lesson_, lesson_.steps()[at_], options_.quiet).page);
}

void Dialogue::print_title() {
  screen_.begin();
  screen_.show([this, at = at_](const Style& style) { return title_text(lesson_, lesson_.steps()[at], style); });
}

Dialogue::Move Dialogue::visit() {
  record();
  print_title();
  for (size_t at = 0;;) {
    const bool ended = !asks(at);
    if (!ended) {
      screen_.show([](const Style&) { return "\n"; });
      view_.show(item(at));
      if (!is_question(*item(at))) {
        ++at;
        continue;
      }
    }
    const Move move = prompt_until_done(at);
    if (move == Move::repeat) {
      at = 0;
      print_title();
    } else if (!ended && (move == Move::next || move == Move::answered)) {
      ++at;
    } else {
      return move;
    }
  }
}

std::string Dialogue::what_can_be_typed(size_t item) const {
  if (!asks(item))
    return fmt::format("Enter goes on{}{}, `?` lists what else can be typed.",
                       goes_deeper() ? fmt::format(", `deeper` shows “{}”", lesson_.steps()[at_ + 1].title) : "",
                       at_ > 0 ? ", `back` goes back" : "");
  const auto* question = std::get_if<Prediction>(&page_->items()[item]);
  if (!question) return "Your choice, or `hint`, `show`, `skip`, `?`";
  const bool plain_number = question->unit.empty() || question->unit == "1";
  return fmt::format("Your prediction{}, or `hint`, `show`, `skip`, `?`",
                     plain_number ? ", a plain number" : " in " + question->unit);
}

std::string Dialogue::unit_asked_for(size_t item) const {
  if (!asks(item)) return "";
  if (const auto* choice = std::get_if<Choice>(&page_->items()[item]))
    return fmt::format("1–{} ", choice->options.size());
  const std::string& unit = std::get<Prediction>(page_->items()[item]).unit;
  return unit.empty() || unit == "1" ? "" : unit + " ";
}

Dialogue::Move Dialogue::prompt_until_done(size_t item) {
  hints_given_ = 0;
  while (true) {
    const auto above = [words = what_can_be_typed(item)](const Style& style) {
      return "\n" + toned(wrapped(words, style), Tone::quiet, style);
    };
    const auto prompt = [unit = unit_asked_for(item)](const Style& style) {
      const std::string_view sign = style.plain ? "> " : "▸ ";
      if (!style.colours) return fmt::format("{}{}", unit, sign);
      return fmt::format("\1\033[1;33m\1{}{}\1\033[0m\1", unit, sign);
    };
    const auto line = screen_.ask(above, prompt);
    if (!line) {
      fmt::print("\n");
      return Move::quit;
    }
    const size_t items = page_->items().size();
    if (const auto move = execute(parse_command(lesson_, *line), item)) return *move;
    if (page_->items().size() != items) return Move::repeat;
  }
}

/// Returns nothing if the prompt stays at this item.
std::optional<Dialogue::Move> Dialogue::execute(const Command& command, size_t item) {
  switch (command.kind) {
    case Command::Kind::next:
      if (asks(item)) print_answer(item);
      return Move::next;
    case Command::Kind::repeat: return Move::repeat;
    case Command::Kind::menu: return Move::menu;
    case Command::Kind::quit: return Move::quit;
    case Command::Kind::back:
      if (at_ > 0) return Move::back;
      say_line("This is where the lesson begins.");
      break;
    case Command::Kind::deeper:
      if (goes_deeper()) return Move::deeper;
      say_line("Nothing goes deeper here.");
      break;
    case Command::Kind::show:
      if (asks(item)) {
        print_answer(item);
        return Move::answered;
      }
      say_line("There is no question here.");
      break;
    case Command::Kind::hint: hint(item); break;
    case Command::Kind::why: why(item); break;
    case Command::Kind::open: open(command.name, item); break;
    case Command::Kind::help: help(); break;
    case Command::Kind::list: list_parameters(); break;
    case Command::Kind::reset: reset(item); break;
    case Command::Kind::query:
      for (const ParameterRecord& p : lesson_.parameters())
        if (p.name == command.name) say_line("{}", p.described(p.value));
      break;
    case Command::Kind::set: change(command, item); break;
    case Command::Kind::answer: return answer(command.value, item);
  }
  return std::nullopt;
}

void Dialogue::print_answer(size_t item) {
  screen_.show([question = this->item(item)](const Style& style) {
    return of_question(*question, [&](const auto& q) { return answer_text(q, style); });
  });
}

/// The next hint of the question; after the last one, the last one again.
void Dialogue::hint(size_t item) {
  if (!asks(item)) return say_line("There is no question here.");
  const auto hints = of_question(*this->item(item), [](const auto& q) { return q.hints; });
  if (hints.empty()) return say_line("This question has no hint.");
  const size_t given = std::min(hints_given_++, hints.size() - 1);
  say_line("{}{}", hints[given], given + 1 < hints.size() ? " (`hint` says more.)" : "");
}

/// The derivations above this item, line by line.
void Dialogue::why(size_t item) {
  bool derived = false;
  for (size_t i = 0; i < std::min(item, page_->items().size()); ++i) {
    if (!std::holds_alternative<Derivation>(*this->item(i))) continue;
    screen_.show([shown = this->item(i), derived](const Style& style) {
      return (derived ? "\n" : "") + derivation_text(std::get<Derivation>(*shown), style);
    });
    derived = true;
  }
  if (!derived) say_line("There is no derivation in this step so far.");
}

/// The picture of this name, or the last one above this item.
void Dialogue::open(const std::string& name, size_t item) {
  const Item* found = nullptr;
  std::string names;
  for (size_t i = 0; i < std::min(item, page_->items().size()); ++i) {
    const Item& seen = page_->items()[i];
    if (!is_picture(seen)) continue;
    names += (names.empty() ? "" : ", ") + name_of(seen);
    if (name.empty() || name_of(seen) == name) found = &seen;
  }
  if (!found)
    return names.empty() ? say_line("There is no picture in this step so far.")
                         : say_line("There is no picture \"{}\" in this step so far, only {}.", name, names);
  const auto* figure = std::get_if<Figure>(found);
  const std::string path = figure ? pictures_.path(*figure) : pictures_.path(std::get<Sequence>(*found));
  if (path.empty()) return say_line("No frames were written: the lesson was started with --frames none.");
  const std::string problem = open_in_viewer(path);
  if (!problem.empty()) say_line("{} The picture is {}", problem, path);
}

std::optional<Dialogue::Move> Dialogue::answer(const std::string& words, size_t item) {
  if (!asks(item)) {
    say_line("There is no question here, and no command or parameter is called \"{}\": `?` lists them.", words);
    return std::nullopt;
  }
  const auto* prediction = std::get_if<Prediction>(this->item(item).get());
  const Grade given = prediction ? grade(*prediction, words, forgettable_factors(lesson_))
                                 : grade(std::get<Choice>(*this->item(item)), words);
  screen_.show([given](const Style& style) {
    const std::string verdict = given.right        ? toned("Yes.", Tone::good, style) + " "
                                : given.understood ? toned("No.", Tone::bad, style) + " "
                                                   : "";
    return wrapped(verdict + given.reply, style, 2);
  });
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
  const std::shared_ptr<const Page> before = page_;
  try {
    lesson_.set(command.name, command.value);
    record();
  } catch (const std::invalid_argument& bad) {
    if (lesson_.is_parameter(command.name)) lesson_.set(command.name, old);
    return say_line("{}. Nothing was changed.", bad.what());
  }
  save({.step = lesson_.steps()[at_].label, .finished = read_bookmark(lesson_.about().slug).finished});
  screen_.show([words = fmt::format("  {}: {} → {}", command.name, old, value())](const Style& style) {
    return "\n" + toned(words, Tone::question, style) + "\n";
  });
  compare(*before, item);
}

void Dialogue::reset(size_t item) {
  if (lesson_.at_defaults()) return say_line("All parameters have their defaults.");
  const std::shared_ptr<const Page> before = page_;
  for (const ParameterRecord& p : lesson_.parameters()) lesson_.set(p.name, p.typed(p.initial));
  record();
  save({.step = lesson_.steps()[at_].label, .finished = read_bookmark(lesson_.about().slug).finished});
  say_line("All parameters have their defaults again.");
  compare(*before, item);
}

/// Numbers and pictures above this item, as they were and as they are.
void Dialogue::compare(const Page& before, size_t item) {
  const auto was = std::make_shared<const Page>(before);
  screen_.show([was, now = page_, item](const Style& style) { return changes_text(*was, *now, item, style); });
  if (item > page_->items().size()) return;
  for (size_t i = 0; i < item; ++i) {
    if (!is_picture(page_->items()[i])) continue;
    const auto old = std::find_if(was->items().begin(), was->items().end(), [&](const Item& other) {
      return is_picture(other) && name_of(other) == name_of(page_->items()[i]);
    });
    screen_.show([](const Style&) { return "\n"; });
    if (old == was->items().end())
      view_.show(this->item(i));
    else
      view_.compare({was, &*old}, this->item(i));
  }
  if (asks(item) && is_question(page_->items()[item])) view_.show(this->item(item));
}

void Dialogue::list_parameters() {
  if (lesson_.parameters().empty()) return say_line("This lesson has no parameters.");
  std::vector<std::vector<std::string>> rows;
  for (const ParameterRecord& p : lesson_.parameters())
    rows.push_back(
        {p.name, p.typed(p.value) + (p.choices.empty() ? " [" + p.unit + "]" : ""), p.allowed(), p.meaning});
  screen_.show([rows](const Style& style) { return table(rows, style, 2); });
}

void Dialogue::help() {
  std::vector<std::vector<std::string>> rows = {{"Enter", "go on"}};
  for (const CommandWord& command : command_words())
    rows.push_back({command.word + (command.key.empty() ? "" : ", " + command.key), command.help});
  screen_.show([rows](const Style& style) { return table(rows, style, 2) + "\n"; });
  if (lesson_.parameters().empty()) return;
  const ParameterRecord& first = lesson_.parameters().front();
  say_line("A name and a value change a parameter and run the step again: `{} {}`. A name alone tells what it is.",
           first.name, first.typed(first.value));
  list_parameters();
}

/// Words that Tab completes: commands, parameters, and the choices of a parameter.
std::vector<std::string> Dialogue::completions(std::string_view before) const {
  std::vector<std::string> words;
  const bool begins = before.find_first_not_of(' ') == std::string_view::npos;
  if (begins)
    for (const CommandWord& command : command_words()) words.push_back(command.word);
  if (begins || before == "set ")
    for (const ParameterRecord& p : lesson_.parameters()) words.push_back(p.name);
  if (before == "open ")
    for (const Item& item : page_->items())
      if (is_picture(item)) words.push_back(name_of(item));
  for (const ParameterRecord& p : lesson_.parameters())
    if (before == p.name + " " || before == "set " + p.name + " ")
      words.insert(words.end(), p.choices.begin(), p.choices.end());
  return words;
}

void Dialogue::leave() {
  say_line("{}", bookmark_saved_ ? "Until next time: the lesson goes on where you stopped."
                                 : "Until next time (the place could not be kept: no writable state folder).");
}

/// Writes the page of the whole lesson, deeper steps included, with the present parameters.
int Dialogue::finish() {
  screen_.begin();
  screen_.show([this](const Style& style) { return closing_text(lesson_, style); });
  std::fflush(stdout);
  std::vector<RecordedStep> steps;
  for (const Step& step : lesson_.steps()) {
    steps.push_back(record_step(lesson_, step, options_.quiet));
    write_pictures(steps.back().page, pictures_);
  }
  validate(steps);
  finish_output(lesson_, steps, options_, true, pictures_);
  save({.step = "", .finished = true});
  const std::string wrong = false_claims(lesson_, steps);
  complain(wrong);
  return wrong.empty() ? 0 : 1;
}

}  // namespace

int run_dialogue(Lesson& lesson, const Options& options) { return Dialogue(lesson, options).run(); }

}  // namespace byhand::course
