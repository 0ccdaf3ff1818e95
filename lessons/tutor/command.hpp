#pragma once

#include <string>
#include <string_view>

namespace byhand::tutor {

class Lesson;

/// What a reader typed at a prompt.
struct Command {
  enum class Kind { go_on, back, deeper, hint, show, again, help, quit, set, look_up, words };
  Kind kind = Kind::words;
  std::string name = {};   // of a parameter, for set and look_up
  std::string value = {};  // what to set, or the words themselves
};

/// Understands the keys, "beta 0.5", "beta=0.5", "beta" for a parameter of the lesson; everything else is
/// words. A key wins over a parameter of the same name that stands alone: `h` hints, `h 1/120` sets.
Command understand(const Lesson& lesson, std::string_view line);

}  // namespace byhand::tutor
