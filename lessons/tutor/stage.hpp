#pragma once

#include "lessons/tutor/items.hpp"
#include "lessons/tutor/keyboard.hpp"
#include "lessons/tutor/studio.hpp"
#include "lessons/tutor/typeset.hpp"

namespace byhand::tutor {

/// The size and the colours of the terminal that standard output is; no colours if NO_COLOR is set or TERM is
/// "dumb".
Style terminal_style();

/// Shows items on the reader's terminal: words, charts in characters, pictures and sequences where there are
/// colours. Each picture is written to its file as it is shown, and its path stands below it.
class Stage {
 public:
  /// All three must outlive it.
  Stage(Studio& studio, Keyboard& keyboard, const Style& style)
      : studio_(studio), keyboard_(keyboard), style_(style) {}

  void show(const Item& item);

 private:
  void play(const Sequence& sequence);

  Studio& studio_;
  Keyboard& keyboard_;
  const Style& style_;
};

}  // namespace byhand::tutor
