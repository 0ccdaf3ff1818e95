#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <string_view>
#include <vector>

namespace byhand::course {

enum class Key { none, enter, space, other, ended };

/// Reads lines and keys from standard input. At a terminal that moves its cursor, a line can be edited (arrow
/// keys, Ctrl-L, Ctrl-R, Tab), and keys that are typed between two prompts wait for the next one without being
/// echoed. While it exists, Ctrl-C acts like the end of input at the next prompt. If the program does not reach a
/// prompt within a second, it exits with the terminal as it was; the bookmark is already saved.
class Keyboard {
 public:
  Keyboard();
  Keyboard(const Keyboard&) = delete;
  Keyboard& operator=(const Keyboard&) = delete;
  ~Keyboard();

  /// Prints `prompt` and returns the next line without its newline; nothing at the end of input and on Ctrl-C.
  /// Escape sequences stand in the prompt between two characters \1.
  std::optional<std::string> line(const std::string& prompt);

  /// Waits at most so long, or without end if negative, for a key. Keys other than Enter and the space bar wait
  /// for the next prompt as well. Without line editing, Enter is the only key.
  Key key_within(int milliseconds);

  /// Words that may continue `before`, the line up to the word at the cursor. Tab completes them.
  using Completion = std::function<std::vector<std::string>(std::string_view before)>;
  void on_tab(Completion completion);

  /// Called when the terminal has another size while a line is typed: prints all that stands above the prompt.
  void on_resize(std::function<void()> redraw);

  bool edits_lines() const { return editor_ != nullptr; }

 private:
  struct Editor;
  std::optional<std::string> read_line(const std::string& prompt);
  std::optional<std::string> plain_line();
  /// Waits for input, which it adds to waiting_. Returns false at the end of input and on Ctrl-C.
  bool wait(int milliseconds, bool or_resized = false);

  std::string waiting_;  // read but not yet returned
  size_t kept_ = 0;      // of these, keys that wait for the next prompt
  std::unique_ptr<Editor> editor_;
};

}  // namespace byhand::course
