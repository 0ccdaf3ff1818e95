#pragma once

#include <cstdint>

namespace byhand::renderer {

/// sRGB with opacity, 0–255 each.
struct Colour {
  std::uint8_t r = 0, g = 0, b = 0, a = 255;
  bool operator==(const Colour&) const = default;
};

/// The same colour at `opacity` 0 … 1.
constexpr Colour fade(Colour colour, double opacity) {
  return {colour.r, colour.g, colour.b, std::uint8_t(colour.a * opacity)};
}

/// From `a` (t = 0) to `b` (t = 1) along a straight line in Oklab, so that equal steps of t look equal.
Colour mix(Colour a, Colour b, double t);

/// Few colours, each with one meaning throughout the course. The hues are those of Okabe and Ito (2008),
/// which people with any of the usual colour deficiencies tell apart; the two darkest are darkened to read as
/// text.
namespace palette {
inline constexpr Colour paper{252, 251, 247};
inline constexpr Colour ink{38, 41, 48};
inline constexpr Colour muted{108, 113, 122};
inline constexpr Colour grid{229, 228, 222};
inline constexpr Colour body{203, 216, 228};
inline constexpr Colour fixed{176, 176, 170};
inline constexpr Colour constraint{0, 114, 178};
inline constexpr Colour force{213, 94, 0};
inline constexpr Colour velocity{0, 140, 102};
inline constexpr Colour error{176, 72, 134};
inline constexpr Colour theory{88, 92, 100};  ///< always dashed
inline constexpr Colour highlight{240, 174, 20};

/// The colour of curve `i`, 0, 1, …; after eight they repeat (markers and labels then tell them apart).
Colour series(int i);

/// From pale to dark, t = 0 … 1 (clamped): equal steps of t look equal, and lightness falls throughout.
Colour sequential(double t);
/// From blue over paper (t = 0) to vermilion, t = −1 … 1 (clamped), with like lightness on both sides.
Colour diverging(double t);
}  // namespace palette

}  // namespace byhand::renderer
