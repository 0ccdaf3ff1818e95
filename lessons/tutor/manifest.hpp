#pragma once

#include <string>

#include "lessons/tutor/lesson.hpp"
#include "lessons/tutor/options.hpp"

namespace byhand::tutor {

/// manifest.json: what made the files beside it. No dates and no names of machines: same options, same bytes.
std::string manifest(const Lesson& lesson, const Options& options, const std::string& gl);

}  // namespace byhand::tutor
