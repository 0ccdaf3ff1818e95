#pragma once

#include <string>
#include <utility>
#include <vector>

namespace byhand::course {

/// How far a reader got in a lesson.
struct Bookmark {
  std::string step;                                           // label of the step shown last; empty: not begun
  bool finished = false;                                      // the end was reached at least once
  std::vector<std::pair<std::string, std::string>> set = {};  // parameters that differ from their defaults
};

/// Reads $XDG_STATE_HOME/constraints-by-hand/<slug>.json, or the same under ~/.local/state. Without a readable
/// file the lesson counts as not begun.
Bookmark read_bookmark(const std::string& slug);

/// Returns false if the file cannot be written, as without a home folder.
bool save_bookmark(const std::string& slug, const Bookmark& bookmark);

}  // namespace byhand::course
