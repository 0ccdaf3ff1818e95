#include "renderer/outline.hpp"

#include <array>
#include <cmath>
#include <numbers>

namespace byhand::renderer {
namespace {

constexpr double feather = 0.5;  // half width [pixels] of the fading border
constexpr double longest_mitre = 3;

// The offset of a corner whose edges are moved outwards by one unit; limited at sharp corners.
Point mitre(const Point& before, const Point& after) {
  const Point sum = left_of(before) + left_of(after);
  const double square = sum.squaredNorm();
  if (square < 1e-12) return left_of(after);
  const Point unit_away = 2 / square * sum;
  const double length = unit_away.norm();
  return length > longest_mitre ? Point(unit_away * (longest_mitre / length)) : unit_away;
}

void triangle(Vertices& to, const Vertex& a, const Vertex& b, const Vertex& c) { to.insert(to.end(), {a, b, c}); }

void quad(Vertices& to, const Vertex& a, const Vertex& b, const Vertex& c, const Vertex& d) {
  triangle(to, a, b, c);
  triangle(to, a, c, d);
}

Vertex plain(const Point& p, Colour colour) { return {float(p.x()), float(p.y()), -1, -1, colour}; }

std::vector<Point> without_repeats(std::span<const Point> points, bool closed) {
  std::vector<Point> distinct;
  for (const Point& p : points)
    if (distinct.empty() || (p - distinct.back()).squaredNorm() > 1e-6) distinct.push_back(p);
  while (closed && distinct.size() > 1 && (distinct.front() - distinct.back()).squaredNorm() <= 1e-6)
    distinct.pop_back();
  return distinct;
}

}  // namespace

void fill(Vertices& to, std::span<const Point> corners, Colour colour) {
  const std::vector<Point> points = without_repeats(corners, true);
  const std::size_t n = points.size();
  if (n < 3) return;
  double twice_area = 0;
  for (std::size_t i = 0; i < n; ++i) {
    const Point &p = points[i], &q = points[(i + 1) % n];
    twice_area += p.x() * q.y() - q.x() * p.y();
  }
  const double outward = twice_area > 0 ? -feather : feather;
  std::vector<Vertex> inner(n), outer(n);
  for (std::size_t i = 0; i < n; ++i) {
    const Point before = (points[i] - points[(i + n - 1) % n]).normalized();
    const Point after = (points[(i + 1) % n] - points[i]).normalized();
    const Point m = outward * mitre(before, after);
    inner[i] = plain(points[i] - m, colour);
    outer[i] = plain(points[i] + m, fade(colour, 0));
  }
  for (std::size_t i = 0; i < n; ++i) {
    const std::size_t next = (i + 1) % n;
    if (i > 0 && next > 0) triangle(to, inner[0], inner[i], inner[next]);
    quad(to, inner[i], inner[next], outer[next], outer[i]);
  }
}

void fill_sharply(Vertices& to, std::span<const Point> corners, Colour colour) {
  for (std::size_t i = 1; i + 1 < corners.size(); ++i)
    triangle(to, plain(corners[0], colour), plain(corners[i], colour), plain(corners[i + 1], colour));
}

void stroke(Vertices& to, std::span<const Point> all, double width, Colour colour, bool closed,
            double first_opacity, double last_opacity) {
  if (width <= 0) return;
  // A line thinner than a pixel is drawn one pixel wide with less opacity.
  if (width < 1) colour = fade(colour, width), width = 1;
  const std::vector<Point> points = without_repeats(all, closed);
  const std::size_t n = points.size();
  if (n < 2) return;
  const double core = width / 2 - feather, edge = width / 2 + feather;
  const auto direction = [&](std::size_t i) -> Point { return (points[(i + 1) % n] - points[i]).normalized(); };

  struct Rung {
    std::array<Vertex, 4> across;
  };
  const auto rung = [&](const Point& at, const Point& m, Colour c) {
    return Rung{{plain(at - edge * m, fade(c, 0)), plain(at - core * m, c), plain(at + core * m, c),
                 plain(at + edge * m, fade(c, 0))}};
  };
  const auto join = [&](const Rung& a, const Rung& b) {
    for (int i = 0; i < 3; ++i) quad(to, a.across[i], b.across[i], b.across[i + 1], a.across[i + 1]);
  };

  Rung last{}, first{};
  const double whole = length(points);
  double done = 0;
  for (std::size_t i = 0; i < n; ++i) {
    if (i > 0) done += (points[i] - points[i - 1]).norm();
    const Colour c = fade(colour, first_opacity + done / whole * (last_opacity - first_opacity));
    const bool start = !closed && i == 0, end = !closed && i == n - 1;
    const Point after = end ? direction(n - 2) : direction(i), before = start ? after : direction((i + n - 1) % n);
    const Point m = mitre(before, after);
    if (start) {
      last = rung(points[0] - feather * after, m, fade(c, 0));
      const Rung full = rung(points[0] + feather * after, m, c);
      join(last, full);
      last = full;
    } else if (end) {
      const Rung full = rung(points[i] - feather * before, m, c);
      join(last, full);
      join(full, rung(points[i] + feather * before, m, fade(c, 0)));
    } else if (i > 0 && before.dot(after) < 0 && width > 1.5) {
      // A corner sharper than a right angle: a butt end, a round joint, a new beginning.
      const Rung stop = rung(points[i], left_of(before), c), go = rung(points[i], left_of(after), c);
      join(last, stop);
      fill(to, circle(points[i], width / 2), c);
      last = go;
    } else {
      const Rung here = rung(points[i], m, c);
      if (i > 0)
        join(last, here);
      else
        first = here;
      last = here;
    }
  }
  if (closed) join(last, first);
}

double length(std::span<const Point> points) {
  double sum = 0;
  for (std::size_t i = 1; i < points.size(); ++i) sum += (points[i] - points[i - 1]).norm();
  return sum;
}

std::vector<Point> circle(const Point& centre, double radius) {
  const double pi = std::numbers::pi;
  const int n = int(std::clamp(std::ceil(pi / std::acos(1 - std::min(0.05 / radius, 1.0))), 12.0, 256.0));
  const double r = radius * std::sqrt(2 * pi / (n * std::sin(2 * pi / n)));
  std::vector<Point> corners;
  for (int i = 0; i < n; ++i) {
    const double angle = 2 * pi * i / n;
    corners.push_back(centre + r * Point(std::cos(angle), std::sin(angle)));
  }
  return corners;
}

std::vector<std::vector<Point>> clipped(std::span<const Point> points, const Rectangle& box) {
  std::vector<std::vector<Point>> runs;
  bool open = false;
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point &p = points[i], &q = points[i + 1];
    const Point d = q - p;
    // Liang and Barsky (1984): the part [t0, t1] of the segment inside the box.
    double t0 = 0, t1 = 1;
    bool inside = p.allFinite() && q.allFinite();
    const std::array<std::array<double, 2>, 4> sides{{{-d.x(), p.x() - box.x},
                                                      {d.x(), box.right() - p.x()},
                                                      {-d.y(), p.y() - box.y},
                                                      {d.y(), box.top() - p.y()}}};
    for (const auto& [towards, distance] : sides) {
      if (towards == 0)
        inside = inside && distance >= 0;
      else if (towards < 0)
        t0 = std::max(t0, distance / towards);
      else
        t1 = std::min(t1, distance / towards);
    }
    if (!inside || t0 > t1) {
      open = false;
      continue;
    }
    if (!open || t0 > 0) runs.push_back({p + t0 * d});
    runs.back().push_back(p + t1 * d);
    open = t1 == 1;
  }
  return runs;
}

std::vector<std::vector<Point>> dashed(std::span<const Point> points, double on, double off) {
  std::vector<std::vector<Point>> pieces;
  bool drawing = true;
  double left = on;
  if (!points.empty()) pieces.push_back({points.front()});
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const Point d = points[i + 1] - points[i];
    const double step = d.norm();
    double done = 0;
    while (step - done > left) {
      done += left;
      const Point at = points[i] + done / step * d;
      if (drawing)
        pieces.back().push_back(at);
      else
        pieces.push_back({at});
      drawing = !drawing;
      left = drawing ? on : off;
    }
    left -= step - done;
    if (drawing) pieces.back().push_back(points[i + 1]);
  }
  return pieces;
}

}  // namespace byhand::renderer
