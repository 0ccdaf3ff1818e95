#pragma once

#include <span>
#include <vector>

#include "renderer/canvas.hpp"

namespace byhand::renderer {

/// A vertex in pixels, y down. u, v: position in the glyph atlas; u < 0 for plain colour.
struct Vertex {
  float x, y;
  float u, v;
  Colour colour;
};

using Vertices = std::vector<Vertex>;

/// The vector turned by a quarter, to the left where y points up.
inline Point left_of(const Point& v) { return {-v.y(), v.x()}; }

/// Appends the triangles of a convex polygon. Its border fades out over one pixel, which is smoother than
/// multisampling and cheaper.
void fill(Vertices& to, std::span<const Point> corners, Colour colour);

/// The same without antialiasing, for edges between pixels.
void fill_sharply(Vertices& to, std::span<const Point> corners, Colour colour);

/// Appends the triangles of a polyline, `width` pixels wide, with the same antialiasing and mitred joints. Its
/// opacity changes from `first` to `last` along its length.
void stroke(Vertices& to, std::span<const Point> points, double width, Colour colour, bool closed = false,
            double first = 1, double last = 1);

/// The length of a path.
double length(std::span<const Point> points);

/// A regular polygon that approximates a disc within 0.05 pixels and has its area.
std::vector<Point> circle(const Point& centre, double radius);

/// The parts of a path inside `box`. Points that are not finite split it.
std::vector<std::vector<Point>> clipped(std::span<const Point> points, const Rectangle& box);

/// The dashes of a path: `on` pixels drawn, `off` pixels left out.
std::vector<std::vector<Point>> dashed(std::span<const Point> points, double on, double off);

}  // namespace byhand::renderer
