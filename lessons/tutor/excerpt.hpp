#pragma once

#include <string>

#include "lessons/tutor/items.hpp"

namespace byhand::tutor {

/// The lines between the two lines `//! [tag]` of `file` under `root`. Markers of other tags inside are left
/// out. Throws LessonError when the file, the pair of markers or the lines between them are missing.
Excerpt read_excerpt(const std::string& root, const std::string& file, const std::string& tag);

}  // namespace byhand::tutor
