#pragma once

#include <string>

#include "lessons/page/items.hpp"

namespace byhand::course {

/// The lines between the two marker lines `//! [tag]` of `file` under `root`, without markers of other tags.
/// Throws EnvironmentError if the file cannot be read, and LessonError if the pair of markers or the
/// lines between them are missing.
Excerpt read_excerpt(const std::string& root, const std::string& file, const std::string& tag);

}  // namespace byhand::course
