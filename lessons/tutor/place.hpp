#pragma once

#include <string>

namespace byhand::tutor {

/// How far a reader got in a lesson.
struct Place {
  std::string step;       // the label of the step last shown; empty: not begun
  bool finished = false;  // the end was reached once
};

/// Reads and keeps the reader's place in $XDG_STATE_HOME/constraints-by-hand/<slug>.json, or under
/// ~/.local/state. A file that cannot be read counts as not begun.
Place read_place(const std::string& slug);

/// Returns whether the place could be kept: a reader without a home folder can still read.
bool keep_place(const std::string& slug, const Place& place);

}  // namespace byhand::tutor
