#pragma once

#include <string>
#include <vector>

namespace byhand::tutor {

/// What a lesson is, before it runs.
struct About {
  std::string slug = {};     // its folder, "04_baumgarte"; the number is read from it
  std::string title = {};    // "Baumgarte"
  std::string summary = {};  // one line for the course
  std::string method = {};   // how its scenes are stepped unless a step says otherwise, for manifest.json
};

/// The lessons of a course, in order. Each course writes its own.
const std::vector<About>& contents();

}  // namespace byhand::tutor
