#pragma once

#include <string>
#include <vector>

namespace byhand::course {

/// Standard output of the program at a path, which is started without a shell. Throws EnvironmentError
/// if it cannot be started or its exit status is not 0.
std::string printed_by(const std::string& path, const std::vector<std::string>& arguments);

}  // namespace byhand::course
