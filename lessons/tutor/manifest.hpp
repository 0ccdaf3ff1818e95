#pragma once

#include <string>
#include <vector>

#include "lessons/tutor/lesson.hpp"
#include "lessons/tutor/options.hpp"
#include "lessons/tutor/told.hpp"

namespace byhand::tutor {

/// manifest.json: what made the files beside it. No dates and no names of machines: same options, same bytes, but
/// for the files that it names as clocked.
std::string manifest(const Lesson& lesson, const std::vector<Told>& told, const Options& options,
                     const std::string& gl);

}  // namespace byhand::tutor
