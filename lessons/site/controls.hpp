#pragma once

#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// Of the parameters that a step reads those, at most two, that a picture is about: named in its caption, then in
/// the step's title, then those that the fewest steps of the lesson read.
std::vector<std::string> knobs(const course::RecordedStep& step, const std::string& caption,
                               const std::vector<course::RecordedStep>& lesson);

/// The section of a step with a place for the controls of each picture, below it, and of the step, at its foot. A
/// live page fills them; it knows their height before, so that nothing moves.
std::string with_controls(std::string section, const course::RecordedStep& step,
                          const std::vector<course::RecordedStep>& lesson);

}  // namespace byhand::site
