#pragma once

#include <string>

namespace byhand::course {

/// Opens a file in the desktop's viewer (xdg-open) without waiting for it. Returns why that cannot be, in a
/// sentence, or nothing.
std::string open_in_viewer(const std::string& path);

}  // namespace byhand::course
