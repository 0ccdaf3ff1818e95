#pragma once

#include <string>

namespace byhand::course {

/// The UTF-8 text with small letters, in every alphabet.
std::string in_lower_case(const std::string& words);

}  // namespace byhand::course
