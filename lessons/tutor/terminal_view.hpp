#pragma once

#include "lessons/tutor/items.hpp"
#include "lessons/tutor/keyboard.hpp"
#include "lessons/tutor/picture_writer.hpp"
#include "lessons/tutor/typeset.hpp"

namespace byhand::tutor {

/// Size and colours of the terminal on standard output. No colours if NO_COLOR is set or TERM is "dumb".
Style terminal_style();

/// Shows items on a terminal: text, charts in characters and, where there are colours, pictures and animations.
/// Writes each picture to its file and prints the path below it.
class TerminalView {
 public:
  /// Keeps references to all three.
  TerminalView(PictureWriter& pictures, Keyboard& keyboard, const Style& style)
      : pictures_(pictures), keyboard_(keyboard), style_(style) {}

  void show(const Item& item);

 private:
  void play(const Sequence& sequence);

  PictureWriter& pictures_;
  Keyboard& keyboard_;
  const Style& style_;
  PictureDrawer small_{small_quality};
};

}  // namespace byhand::tutor
