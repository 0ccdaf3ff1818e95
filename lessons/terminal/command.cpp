#include "lessons/terminal/command.hpp"

#include <algorithm>

#include "lessons/page/lesson.hpp"

namespace byhand::course {
namespace {

std::string trimmed(std::string_view line) {
  const auto first = line.find_first_not_of(" \t\r");
  if (first == std::string_view::npos) return "";
  return std::string(line.substr(first, line.find_last_not_of(" \t\r") - first + 1));
}

std::string in_lower_case(std::string words) {
  for (char& c : words)
    if (c >= 'A' && c <= 'Z') c = static_cast<char>(c - 'A' + 'a');
  return words;
}

/// "set", "beta 0.5", "beta=0.5" or "beta", without the word `set`.
Command parse_setting(const Lesson& lesson, const std::string& words) {
  using Kind = Command::Kind;
  const auto end = words.find_first_of(" \t=");
  const std::string name = words.substr(0, end);
  if (!lesson.is_parameter(name)) return {Kind::answer, "", words};
  if (end == std::string::npos) return {Kind::query, name, ""};
  std::string value = trimmed(std::string_view(words).substr(end));
  if (value.starts_with('=')) value = trimmed(std::string_view(value).substr(1));
  return {Kind::set, name, value};
}

}  // namespace

const std::vector<CommandWord>& command_words() {
  using Kind = Command::Kind;
  static const std::vector<CommandWord> words = {
      {"skip", "", Kind::next, "go on, as Enter does; a question that is passed explains its answer"},
      {"hint", "h", Kind::hint, "a hint for the question, more of them each time"},
      {"show", "s", Kind::show, "the answer"},
      {"why", "w", Kind::why, "the derivation, line by line, where the text offers one"},
      {"open", "o", Kind::open, "the last picture in the desktop's viewer; `open NAME` another one of this step"},
      {"deeper", "d", Kind::deeper, "an optional step, where one is offered"},
      {"back", "b", Kind::back, "the step before"},
      {"again", "r", Kind::repeat, "this step from its beginning"},
      {"set", "", Kind::list, "all parameters; `set NAME VALUE`, or only `NAME VALUE`, changes one"},
      {"reset", "", Kind::reset, "all parameters back to their defaults"},
      {"menu", "m", Kind::menu, "the lessons of the course"},
      {"quit", "q", Kind::quit, "leave; place and parameters are remembered"},
      {"?", "help", Kind::help, "this list"}};
  return words;
}

Command parse_command(const Lesson& lesson, std::string_view line) {
  using Kind = Command::Kind;
  const std::string words = trimmed(line);
  if (words.empty()) return {Kind::next, "", ""};
  const auto blank = words.find_first_of(" \t");
  const std::string first = in_lower_case(words.substr(0, blank));
  const std::string rest = blank == std::string::npos ? "" : trimmed(std::string_view(words).substr(blank));
  if (first == "set" && !rest.empty()) {
    const Command setting = parse_setting(lesson, rest);
    // An unknown name is refused as such, and not as an answer.
    return setting.kind == Kind::answer ? Command{Kind::set, rest.substr(0, rest.find_first_of(" \t=")), ""}
                                        : setting;
  }
  for (const CommandWord& command : command_words()) {
    if (first != command.word && first != command.key) continue;
    if (rest.empty() || command.kind == Kind::open) return {command.kind, rest, ""};
  }
  return parse_setting(lesson, words);
}

}  // namespace byhand::course
