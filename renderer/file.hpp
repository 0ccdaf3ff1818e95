#pragma once

#include <filesystem>
#include <string_view>

namespace byhand::renderer {

/// Writes a file atomically: writes `<path>.part`, then renames it. Creates missing folders. Throws
/// EnvironmentError with path and reason, and then leaves an old file unchanged.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

}  // namespace byhand::renderer
