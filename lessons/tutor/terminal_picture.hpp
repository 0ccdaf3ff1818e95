#pragma once

#include <string>

#include "renderer/image.hpp"

namespace byhand::tutor {

/// Characters in colours that show the image in at most `columns` × `rows` cells. In 24-bit colours where the
/// terminal says that it has them (COLORTERM), else in 256.
std::string terminal_picture(const renderer::Image& image, int columns, int rows);

}  // namespace byhand::tutor
