#pragma once

#include <optional>
#include <string>

namespace byhand::tutor {

/// Reads lines from standard input. While it exists, Ctrl-C acts like the end of input at the next prompt. If the
/// program does not reach a prompt within a second, it exits with the terminal's colours reset and the status 130;
/// the bookmark is already saved.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// The next line without its newline; nothing at the end of input and on Ctrl-C.
  std::optional<std::string> line();

  /// Waits for input at most so long; returns whether line() has something to tell: input, its end or Ctrl-C.
  bool pressed_within(int milliseconds);

 private:
  std::string rest_;  // read but not yet returned
};

}  // namespace byhand::tutor
