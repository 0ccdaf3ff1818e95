#pragma once

#include <filesystem>
#include <string>

#include "renderer/image.hpp"

namespace byhand::renderer {

/// The bytes of a PNG file, RGB with 8 bits a channel: the same for the same image, always.
/// Throws std::invalid_argument when the size does not match the number of bytes, or is not positive.
std::string encode_png(const Image& image);

/// Writes `image` to `path`, whole or not at all; throws as `encode_png` and `write_whole` do.
void write_png(const std::filesystem::path& path, const Image& image);

/// Reads a picture back (any PNG; alpha is dropped). Throws EnvironmentError when there is none to be read.
Image read_png(const std::filesystem::path& path);

}  // namespace byhand::renderer
