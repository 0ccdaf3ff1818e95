#pragma once

#include <memory>
#include <optional>
#include <string>

#include "lessons/files/picture_writer.hpp"
#include "lessons/page/items.hpp"
#include "lessons/terminal/keyboard.hpp"
#include "lessons/terminal/screen.hpp"
#include "renderer/canvas.hpp"

namespace byhand::course {

/// Shows items on a terminal: text, and pictures as the terminal can show them: real ones, in characters, or, for
/// screen readers, in words. Writes each picture to its file and prints the path below it.
class TerminalView {
 public:
  /// Keeps references to all three.
  TerminalView(PictureWriter& pictures, Keyboard& keyboard, Screen& screen)
      : pictures_(pictures), keyboard_(keyboard), screen_(screen) {}

  void show(const std::shared_ptr<const Item>& item);

  /// Shows two pictures of the same name side by side, or one below the other on a narrow terminal, and writes the
  /// second one.
  void compare(const std::shared_ptr<const Item>& before, const std::shared_ptr<const Item>& now);

 private:
  void play(const Sequence& sequence);
  std::string picture(const Item& item, const Style& style, int columns);
  std::string characters(const Item& item, const Style& style, int columns);
  renderer::Image image(const Item& item);
  std::string caption(const Item& item, const Style& style) const;
  void write(const Item& item);

  PictureWriter& pictures_;
  Keyboard& keyboard_;
  Screen& screen_;
  std::optional<renderer::PixelCanvas> for_characters_, for_images_;
};

}  // namespace byhand::course
