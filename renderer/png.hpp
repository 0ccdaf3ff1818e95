#pragma once

#include <string>

#include "renderer/image.hpp"

namespace byhand::renderer {

/// Thorough takes twenty times as long for four fifths of the size: for pictures that readers load often.
enum class Compression { quick, thorough };

/// Encodes a PNG file, RGB with 8 bits per channel. The same image always gives the same bytes. Throws
/// std::invalid_argument if the size is not positive or does not match the number of bytes.
std::string encode_png(const Image& image, Compression compression = Compression::quick);

}  // namespace byhand::renderer
