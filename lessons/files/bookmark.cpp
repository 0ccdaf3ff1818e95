#include "lessons/files/bookmark.hpp"

#include <cstdlib>
#include <filesystem>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/lesson_json.hpp"
#include "lessons/page/error.hpp"

namespace byhand::course {
namespace {

namespace fs = std::filesystem;

/// Empty without a home folder.
fs::path bookmark_file(const std::string& slug) {
  const char* const state = std::getenv("XDG_STATE_HOME");
  const char* const home = std::getenv("HOME");
  fs::path folder;
  // The XDG base directory specification asks to ignore relative paths.
  if (state && fs::path(state).is_absolute())
    folder = state;
  else if (home && *home)
    folder = fs::path(home) / ".local" / "state";
  else
    return {};
  return folder / "constraints-by-hand" / (slug + ".json");
}

}  // namespace

Bookmark read_bookmark(const std::string& slug) {
  return bookmark_from_json(read_whole(bookmark_file(slug)).value_or(""));
}

bool save_bookmark(const std::string& slug, const Bookmark& bookmark) {
  const fs::path file = bookmark_file(slug);
  if (file.empty()) return false;
  try {
    write_whole(file, to_json(bookmark));
  } catch (const EnvironmentError&) {
    return false;
  }
  return true;
}

}  // namespace byhand::course
