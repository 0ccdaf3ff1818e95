#pragma once

#include <filesystem>
#include <string_view>

namespace byhand::renderer {

/// Writes `bytes` to `path`, whole or not at all: into `<path>.part` beside it, then renamed over it. Missing
/// folders are made. Throws EnvironmentError that names the path and the reason; the old file, if any, then
/// stays.
void write_whole(const std::filesystem::path& path, std::string_view bytes);

}  // namespace byhand::renderer
