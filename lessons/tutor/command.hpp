#pragma once

#include <string>
#include <string_view>

namespace byhand::tutor {

class Lesson;

/// A line that a reader typed at a prompt.
struct Command {
  enum class Kind { next, back, deeper, hint, why, show, repeat, help, quit, set, query, answer };
  Kind kind = Kind::answer;
  std::string name = {};   // of the parameter, for set and query
  std::string value = {};  // new value of the parameter, or the answer
};

/// Parses a key, "beta 0.5" or "beta=0.5" (set) or "beta" (query) for a parameter of the lesson; any other line is
/// an answer. A key takes precedence over a parameter of the same name without a value: `h` hints, `h 1/120` sets.
Command parse_command(const Lesson& lesson, std::string_view line);

}  // namespace byhand::tutor
