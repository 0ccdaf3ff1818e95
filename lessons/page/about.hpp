#pragma once

#include <stdexcept>
#include <string>
#include <string_view>
#include <vector>

namespace byhand::course {

/// What the course lists of a lesson without running it.
struct About {
  std::string slug = {};                // its folder, "04_baumgarte"; the number is read from it
  std::string title = {};               // "Baumgarte"
  std::string summary = {};             // one line for the course
  std::string method = {};              // default time-stepping method of its scenes, for manifest.json
  std::vector<std::string> goals = {};  // what its reader can do afterwards, each after "You can "
  std::string before = {};              // what it takes to follow
  std::string native = {};              // why no browser can run its program; empty where one can
};

/// The lessons of the course, in order. Defined by each course.
const std::vector<About>& contents();

/// The lesson whose folder holds this source: `lesson_of(__FILE__)`. Throws std::out_of_range if the course has
/// none of that name.
inline const About& lesson_of(std::string_view source) {
  const std::string_view folder = source.substr(0, source.find_last_of('/'));
  for (const About& lesson : contents())
    if (folder.ends_with(lesson.slug)) return lesson;
  throw std::out_of_range("the course has no lesson for " + std::string(source));
}

}  // namespace byhand::course
