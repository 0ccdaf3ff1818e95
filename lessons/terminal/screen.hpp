#pragma once

#include <functional>
#include <optional>
#include <string>
#include <vector>

#include "lessons/terminal/keyboard.hpp"
#include "lessons/terminal/typeset.hpp"

namespace byhand::course {

/// Prints on a terminal, one screenful at a time: where the next block would push unread lines off the screen, it
/// waits for a key first. When the terminal gets another size at a prompt, it prints the blocks anew for that
/// size.
class Screen {
 public:
  /// A block of lines for a terminal, ending with a newline. It may be called again.
  using Block = std::function<std::string(const Style&)>;

  /// Keeps a reference to the keyboard.
  Screen(Keyboard& keyboard, bool plain);

  /// The terminal as it is now.
  Style style() const;

  /// `rows`: height of the block if it is a picture in one escape sequence.
  void show(Block block, int rows = 0);
  /// Notes a block as printed which its owner printed itself.
  void printed(Block block, int rows);

  /// Waits for a key unless as many rows are free.
  void make_room(int rows);

  /// Prints `above` and a prompt and returns the line that is typed; nothing at the end of input.
  std::optional<std::string> ask(const Block& above, const Block& prompt);

  /// Forgets the blocks so far: they are not printed again.
  void begin() { blocks_.clear(); }

 private:
  struct Shown {
    Block block;
    int rows;
  };
  void pause();
  void print(const std::string& lines, int rows);
  void print_again();

  Keyboard& keyboard_;
  bool plain_, pages_, ended_ = false;
  int used_ = 0;  // rows since the reader's last key
  std::vector<Shown> blocks_;
};

}  // namespace byhand::course
