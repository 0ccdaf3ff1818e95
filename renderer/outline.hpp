#pragma once

#include <span>
#include <vector>

#include "renderer/canvas.hpp"

namespace byhand::renderer {

/// A corner of a triangle in pixels, y down. A glyph's corners carry the place in the atlas; u < 0: plain
/// colour.
struct Vertex {
  float x, y;
  float u, v;
  Colour colour;
};

using Vertices = std::vector<Vertex>;

/// The vector turned by a quarter, to the left where y points up.
inline Point left_of(const Point& v) { return {-v.y(), v.x()}; }

/// Triangles of a convex polygon. Its border fades from opaque to clear over the pixel that it crosses:
/// smoother than multisampling, and cheaper.
void fill(Vertices& to, std::span<const Point> corners, Colour colour);

/// The same without the soft border, for sides that lie between pixels.
void fill_sharply(Vertices& to, std::span<const Point> corners, Colour colour);

/// Triangles of a line `width` pixels wide along `points`, with the same soft border and mitred joints. Its
/// opacity goes from `first` to `last` along its length.
void stroke(Vertices& to, std::span<const Point> points, double width, Colour colour, bool closed = false,
            double first = 1, double last = 1);

/// The length of a path.
double length(std::span<const Point> points);

/// The corners of a regular polygon that has the area of a disc and looks like one.
std::vector<Point> circle(const Point& centre, double radius);

/// The parts of a path that lie inside `box`. Points that are not finite divide it.
std::vector<std::vector<Point>> clipped(std::span<const Point> points, const Rectangle& box);

/// The pieces of a path that a pattern of `on` and `off` pixels leaves.
std::vector<std::vector<Point>> dashed(std::span<const Point> points, double on, double off);

}  // namespace byhand::renderer
