#pragma once

#include <vector>

namespace byhand::renderer {

/// The bytes of a font of DejaVu, "DejaVuSans.ttf". Here from the system's fonts; a program without files (in a
/// browser) has its own definition. Throws Unavailable if the font is missing or damaged.
std::vector<unsigned char> font_file(const char* name);

}  // namespace byhand::renderer
