#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace byhand::course {

class Lesson;

/// A line that a reader typed at a prompt.
struct Command {
  enum class Kind {
    next,
    back,
    deeper,
    hint,
    why,
    show,
    open,
    repeat,
    menu,
    reset,
    help,
    quit,
    list,
    set,
    query,
    answer
  };
  Kind kind = Kind::answer;
  std::string name = {};   // of the parameter, for set and query; of the picture, for open
  std::string value = {};  // new value of the parameter, or the answer
};

/// Parses a word of `command_words` or its first letter, "open errors", "set beta 0.5", "beta 0.5" or "beta=0.5"
/// (set) or "beta" (query) for a parameter of the lesson; any other line is an answer. A key takes precedence over
/// a parameter of the same name without a value: `h` hints, `h 1/120` sets. Every command in the order in which
/// help lists them.
struct CommandWord {
  std::string word, key;  // "back", "b"; the key may be empty
  Command::Kind kind;
  std::string help;
};
const std::vector<CommandWord>& command_words();

Command parse_command(const Lesson& lesson, std::string_view line);

}  // namespace byhand::course
