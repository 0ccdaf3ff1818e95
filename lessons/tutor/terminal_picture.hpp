#pragma once

#include <string>

#include "renderer/image.hpp"

namespace byhand::tutor {

/// The image in coloured characters, at most `columns` × `rows` cells: in 24-bit colours if COLORTERM announces
/// them, else in 256 colours.
std::string terminal_picture(const renderer::Image& image, int columns, int rows);

}  // namespace byhand::tutor
