#pragma once

#include <filesystem>

#include "renderer/image.hpp"

namespace byhand::renderer {

/// Reads a PNG file, without alpha, with stb's decoder. Throws std::runtime_error if it cannot.
Image read_png(const std::filesystem::path& path);

/// Writes encode_png(image) and makes missing folders. Throws std::runtime_error if it cannot.
void write_png(const std::filesystem::path& path, const Image& image);

}  // namespace byhand::renderer
