#pragma once

#include <string>
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

}  // namespace byhand::course
