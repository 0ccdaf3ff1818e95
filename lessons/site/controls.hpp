#pragma once

#include <functional>
#include <string>
#include <vector>

#include "lessons/page/recording.hpp"

namespace byhand::site {

/// Whether a parameter changes what is seen of the picture of that name (see TurnedStep).
using Changes = std::function<bool(const std::string& picture, const std::string& parameter)>;

/// Of the parameters that change a picture those, at most two, that it is about: named in its caption, then in the
/// step's title, then those that the fewest steps of the lesson read.
std::vector<std::string> knobs(const course::RecordedStep& step, const std::string& picture,
                               const std::string& caption, const std::vector<course::RecordedStep>& lesson,
                               const Changes& changes);

/// The section of a step with a place for the controls of each picture, below it, and of the step, at its foot. A
/// live page fills them; it knows their height before, so that nothing moves.
std::string with_controls(std::string section, const course::RecordedStep& step,
                          const std::vector<course::RecordedStep>& lesson, const Changes& changes);

}  // namespace byhand::site
