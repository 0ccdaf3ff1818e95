#pragma once

#include <span>
#include <string_view>

#include "renderer/palette.hpp"
#include "renderer/point.hpp"

namespace byhand::renderer {

class Space;

/// A rectangle of pixels, y down.
struct PixelBox {
  int x = 0, y = 0, width = 0, height = 0;
  bool operator==(const PixelBox&) const = default;
};

/// The size of a page in pixels: 16 … 8192 on each side, else std::invalid_argument.
struct PageSize {
  PageSize(int width_, int height_);
  int width, height;
};

/// How a line is drawn; lengths in pixels.
struct Pen {
  Colour colour{};
  double width = 0;        ///< 0 draws nothing
  double on = 0, off = 0;  ///< lengths of dashes and gaps; on = 0: solid
  double opacity_at_start = 1, opacity_at_end = 1;
};

/// A line of text, with markup as in Canvas. Its baseline begins at `at`.
struct TextLine {
  std::string_view words;
  Point at;
};

struct Lettering {
  double size = 0;  ///< pixels
  bool bold = false;
  Colour colour{};
  double halo = 0;      ///< pixels of paper around the letters, below the letters of all lines
  bool upright = true;  ///< false: each line is rotated by 90° anticlockwise about its `at`
};

/// What a canvas draws on: pixels or SVG. Positions in pixels, y down, all finite. Later shapes cover earlier
/// ones.
class DrawingSurface {
 public:
  virtual ~DrawingSurface() = default;

  /// Empties the page and removes the clipping.
  virtual void clear(Colour paper) = 0;
  /// The page ends so many pixels below its top; on a surface of pixels the rest stays empty.
  virtual void cut(int /*height*/) {}
  /// Clips later shapes to `box`.
  virtual void clip(const PixelBox& box) = 0;
  /// A convex polygon. `sharp`: without antialiasing, because its edges lie between pixels.
  virtual void polygon(std::span<const Point> corners, Colour fill, const Pen& edge, bool sharp) = 0;
  virtual void disc(const Point& centre, double radius, Colour fill, const Pen& edge) = 0;
  virtual void path(std::span<const Point> points, const Pen& pen) = 0;
  virtual void text(std::span<const TextLine> lines, const Lettering& lettering) = 0;
  /// Width [pixels] of a line, with markup as in Canvas, in letters of `size` pixels.
  virtual double text_width(std::string_view line, double size, bool bold) const = 0;
  /// A scene in space that fills `frame`.
  virtual void space(const Space& space, const PixelBox& frame) = 0;
};

}  // namespace byhand::renderer
