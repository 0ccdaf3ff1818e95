#pragma once

#include <string>

namespace byhand::course {

inline constexpr int dots_across = 2, dots_down = 4;  // of a character cell

/// The bit of the dot in column `x` from the left and row `y` from the top.
constexpr unsigned braille_dot(int x, int y) { return y == 3 ? 0x40U << x : 1U << (y + 3 * x); }

/// The character with these dots, in UTF-8.
inline std::string braille(unsigned dots) {
  return {static_cast<char>(0xE2), static_cast<char>(0xA0 | (dots >> 6)), static_cast<char>(0x80 | (dots & 0x3F))};
}

}  // namespace byhand::course
