#pragma once

#include <string>
#include <string_view>
#include <vector>

namespace byhand::course {

/// The name that differs from `typed` in the fewest letters, added, left out or replaced; empty if that is more
/// than half of the letters.
std::string nearest(std::string_view typed, const std::vector<std::string>& names);

/// " (do you mean NAME?)", or nothing.
std::string suggestion(std::string_view typed, const std::vector<std::string>& names);

}  // namespace byhand::course
