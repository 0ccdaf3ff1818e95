#include "renderer/palette.hpp"

#include <algorithm>
#include <array>
#include <cmath>

#include "renderer/point.hpp"

namespace byhand::renderer {
namespace {

// A 3 × 3 matrix by its rows.
using Matrix = std::array<Point3, 3>;

Point3 operator*(const Matrix& m, const Point3& v) { return {m[0].dot(v), m[1].dot(v), m[2].dot(v)}; }

Matrix transposed(const Matrix& m) {
  return {Point3(m[0].x(), m[1].x(), m[2].x()), Point3(m[0].y(), m[1].y(), m[2].y()),
          Point3(m[0].z(), m[1].z(), m[2].z())};
}

// The adjugate over the determinant.
Matrix inverse(const Matrix& m) {
  const Point3 first = m[1].cross(m[2]);
  const double determinant = m[0].dot(first);
  return transposed({first / determinant, m[2].cross(m[0]) / determinant, m[0].cross(m[1]) / determinant});
}

template <class F>
Point3 each(const Point3& v, F f) {
  return {f(v.x()), f(v.y()), f(v.z())};
}

// Oklab, B. Ottosson, "A perceptual color space for image processing" (2020): linear sRGB -> LMS -> Lab.
const Matrix to_lms{Point3(0.4122214708, 0.5363325363, 0.0514459929),
                    Point3(0.2119034982, 0.6806995451, 0.1073969566),
                    Point3(0.0883024619, 0.2817188376, 0.6299787005)};
const Matrix to_lab{Point3(0.2104542553, 0.7936177850, -0.0040720468),
                    Point3(1.9779984951, -2.4285922050, 0.4505937099),
                    Point3(0.0259040371, 0.7827717662, -0.8086757660)};
const Matrix from_lms = inverse(to_lms), from_lab = inverse(to_lab);

double linear(std::uint8_t channel) {
  const double c = channel / 255.0;
  return c <= 0.04045 ? c / 12.92 : std::pow((c + 0.055) / 1.055, 2.4);
}

std::uint8_t encoded(double c) {
  c = std::clamp(c, 0.0, 1.0);
  return std::uint8_t(std::lround(255 * (c <= 0.0031308 ? 12.92 * c : 1.055 * std::pow(c, 1 / 2.4) - 0.055)));
}

Point3 oklab(Colour c) {
  const Point3 lms = to_lms * Point3(linear(c.r), linear(c.g), linear(c.b));
  return to_lab * each(lms, [](double v) { return std::pow(std::max(v, 0.0), 1.0 / 3); });
}

Colour from_oklab(const Point3& lab) {
  const Point3 lms = each(from_lab * lab, [](double v) { return v * v * v; });
  const Point3 rgb = from_lms * lms;
  return {encoded(rgb.x()), encoded(rgb.y()), encoded(rgb.z())};
}

double luminance(Colour c) { return 0.2126 * linear(c.r) + 0.7152 * linear(c.g) + 0.0722 * linear(c.b); }

}  // namespace

Colour mix(Colour a, Colour b, double t) {
  Colour colour = from_oklab((1 - t) * oklab(a) + t * oklab(b));
  colour.a = std::uint8_t(std::lround((1 - t) * a.a + t * b.a));
  return colour;
}

double contrast(Colour a, Colour b) {
  const auto [low, high] = std::minmax({luminance(a), luminance(b)});
  return (high + 0.05) / (low + 0.05);
}

Colour legible(Colour colour) {
  constexpr double needed = 4.5, light = 0.5;
  if (luminance(colour) > light) return colour;
  Colour darker = colour;
  for (int i = 1; i <= 20 && contrast(darker, palette::paper) < needed; ++i)
    darker = mix(colour, palette::ink, 0.05 * i);
  darker.a = colour.a;
  return darker;
}

namespace palette {

Colour series(int i) {
  static constexpr std::array<Colour, 15> colours{{{0, 114, 178},
                                                   {213, 94, 0},
                                                   {0, 140, 102},
                                                   {176, 72, 134},
                                                   {118, 157, 43},
                                                   {92, 76, 245},
                                                   {38, 41, 48},
                                                   {112, 68, 57},
                                                   muted,
                                                   {0, 139, 160},
                                                   {122, 74, 160},
                                                   {150, 90, 30},
                                                   {190, 60, 70},
                                                   {60, 120, 60},
                                                   {40, 70, 130}}};
  constexpr int count = colours.size();
  return colours[std::size_t(i % count + count) % count];
}

Colour sequential(double t) {
  t = std::clamp(t, 0.0, 1.0);
  // Equal distances in Oklab from one stop to the next make equal steps of t look equal.
  static const std::array<Point3, 3> stops{Point3(0.965, -0.012, 0.045), Point3(0.665, -0.085, -0.045),
                                           Point3(0.30, -0.005, -0.115)};
  static const double first = (stops[1] - stops[0]).norm(), second = (stops[2] - stops[1]).norm();
  const double at = t * (first + second);
  return from_oklab(at < first ? stops[0] + at / first * (stops[1] - stops[0])
                               : stops[1] + (at - first) / second * (stops[2] - stops[1]));
}

Colour diverging(double t) {
  t = std::clamp(t, -1.0, 1.0);
  static const Point3 middle = oklab(paper), cold(0.47, -0.055, -0.135), warm(0.47, 0.13, 0.09);
  return from_oklab(middle + std::abs(t) * ((t < 0 ? cold : warm) - middle));
}

}  // namespace palette
}  // namespace byhand::renderer
