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

/// Interpolates linearly in Oklab from `a` (t = 0) to `b` (t = 1), so that equal steps of t look equal.
Colour mix(Colour a, Colour b, double t);

/// Ratio of luminances as the Web Content Accessibility Guidelines define it, 1 … 21.
double contrast(Colour a, Colour b);

/// The colour, or the nearest one on the way to ink that has a contrast of 4.5 on paper, as text needs it. A light
/// colour, for text on dark, stays.
Colour legible(Colour colour);

/// The colours of the course, each with one meaning. The hues are those of Okabe and Ito (2008), distinguishable
/// with the usual colour vision deficiencies; two are darkened so that they are legible as text.
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

/// Colour of curve `i`, 0, 1, …; repeats after fifteen. Each has a contrast of 3 on paper, as lines need it; the
/// first eight are the easiest to tell apart.
Colour series(int i);

/// Sequential colour map, pale to dark for t = 0 … 1 (clamped): perceptually uniform, with decreasing lightness.
Colour sequential(double t);
/// Diverging colour map, blue over paper (t = 0) to vermilion for t = −1 … 1 (clamped), with equal lightness on
/// both sides.
Colour diverging(double t);
}  // namespace palette

}  // namespace byhand::renderer
