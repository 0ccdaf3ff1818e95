#pragma once

#include <optional>
#include <string>

namespace byhand::tutor {

/// Lines from standard input while a reader is there. As long as it lives, Ctrl-C ends a wait for a line as the
/// end of input does; what takes longer than a second to come to that wait is ended then, with the terminal as it
/// was: a place kept before is all that need survive.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// The next line without its end; nothing at the end of input, on Ctrl-C or Ctrl-D.
  std::optional<std::string> line();

  /// Waits until a line was begun or the time is over; returns whether there is one.
  bool pressed_within(int milliseconds);

 private:
  std::string rest_;
};

}  // namespace byhand::tutor
