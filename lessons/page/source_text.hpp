#pragma once

#include <optional>
#include <string>

namespace byhand::course {

/// The whole file; empty if it cannot be read. A program in a browser has its own definition.
std::optional<std::string> source_text(const std::string& path);

}  // namespace byhand::course
