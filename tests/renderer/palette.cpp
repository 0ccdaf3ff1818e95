#include "renderer/palette.hpp"

#include <gtest/gtest.h>

#include <Eigen/Core>
#include <array>
#include <cmath>

namespace byhand::renderer {
namespace {

using Eigen::Matrix3d;
using Eigen::Vector3d;

Vector3d linear(Colour c) {
  const auto decoded = [](int channel) {
    const double v = channel / 255.0;
    return v <= 0.04045 ? v / 12.92 : std::pow((v + 0.055) / 1.055, 2.4);
  };
  return {decoded(c.r), decoded(c.g), decoded(c.b)};
}

// CIE L*a*b* (D65), a measure of difference independent of the one that the palette is made with.
Vector3d lab(const Vector3d& rgb) {
  Matrix3d to_xyz;
  to_xyz << 0.4124564, 0.3575761, 0.1804375, 0.2126729, 0.7151522, 0.0721750, 0.0193339, 0.1191920, 0.9503041;
  const Vector3d xyz = to_xyz * rgb.cwiseMax(0).cwiseMin(1), w(0.95047, 1, 1.08883);
  const auto f = [](double t) { return t > 0.008856 ? std::cbrt(t) : 7.787 * t + 16 / 116.0; };
  const double x = f(xyz.x() / w.x()), y = f(xyz.y() / w.y()), z = f(xyz.z() / w.z());
  return {116 * y - 16, 500 * (x - y), 200 * (y - z)};
}

// Machado, Oliveira, Fernandes (2009), severity 1: what people see who lack one kind of cone.
const std::array<Matrix3d, 4> eyes{
    Matrix3d::Identity(),
    (Matrix3d() << 0.152286, 1.052583, -0.204868, 0.114503, 0.786281, 0.099216, -0.003882, -0.048116, 1.051998)
        .finished(),
    (Matrix3d() << 0.367322, 0.860646, -0.227968, 0.280085, 0.672501, 0.047413, -0.011820, 0.042940, 0.968881)
        .finished(),
    (Matrix3d() << 1.255528, -0.076749, -0.178779, -0.078411, 0.930809, 0.147602, 0.004733, 0.691367, 0.303900)
        .finished()};

TEST(Palette, CurvesStayApartForAllEyes) {
  for (std::size_t eye = 0; eye < eyes.size(); ++eye)
    for (int i = 0; i < 8; ++i)
      for (int j = 0; j < i; ++j) {
        const double d =
            (lab(eyes[eye] * linear(palette::series(i))) - lab(eyes[eye] * linear(palette::series(j)))).norm();
        EXPECT_GT(d, 10) << "curves " << i << " and " << j << " for eye " << eye;
      }
}

TEST(Palette, CurvesAreSeenOnPaper) {
  for (int i = 0; i < 15; ++i) EXPECT_GT(contrast(palette::series(i), palette::paper), 3) << "curve " << i;
}

TEST(Palette, ContrastIsThatOfTheGuidelines) {
  EXPECT_NEAR(contrast({0, 0, 0}, {255, 255, 255}), 21, 1e-9);
  EXPECT_NEAR(contrast({119, 119, 119}, {255, 255, 255}), 4.48, 0.005);  // #777 on white, which fails by little
  EXPECT_EQ(contrast({1, 2, 3}, {100, 50, 3}), contrast({100, 50, 3}, {1, 2, 3}));
}

TEST(Palette, LegibleTextHasTheContrastOfTheGuidelines) {
  for (int i = 0; i < 15; ++i)
    EXPECT_GE(contrast(legible(palette::series(i)), palette::paper), 4.5) << "curve " << i;
  for (const Colour c : {palette::force, palette::velocity, palette::error, palette::muted, palette::theory})
    EXPECT_GE(contrast(legible(c), palette::paper), 4.5);
  EXPECT_EQ(legible(palette::ink), palette::ink);
  EXPECT_EQ(legible(palette::constraint), palette::constraint);
  EXPECT_EQ(legible(palette::paper), palette::paper) << "text on dark";
}

TEST(Palette, MeaningsStayApartForAllEyes) {
  const std::array meanings{palette::constraint, palette::force,     palette::velocity,
                            palette::error,      palette::highlight, palette::ink};
  for (const Matrix3d& eye : eyes)
    for (std::size_t i = 0; i < meanings.size(); ++i)
      for (std::size_t j = 0; j < i; ++j)
        EXPECT_GT((lab(eye * linear(meanings[i])) - lab(eye * linear(meanings[j]))).norm(), 10)
            << i << " and " << j;
}

TEST(Palette, TextCanBeReadOnPaper) {
  const auto contrast = [](Colour c) {
    const Vector3d weights(0.2126, 0.7152, 0.0722);
    return (weights.dot(linear(palette::paper)) + 0.05) / (weights.dot(linear(c)) + 0.05);
  };
  // WCAG 2.1: 4.5 for text, 3 for what is drawn.
  for (const Colour c : {palette::ink, palette::muted, palette::theory, palette::constraint})
    EXPECT_GT(contrast(c), 4.5);
  for (const Colour c : {palette::force, palette::velocity, palette::error}) EXPECT_GT(contrast(c), 3);
}

TEST(Palette, MapsHaveEqualStepsAndOneDirection) {
  std::array<double, 32> steps{};
  double total = 0;
  for (int i = 0; i < 32; ++i) {
    const Vector3d a = lab(linear(palette::sequential(i / 32.0))),
                   b = lab(linear(palette::sequential((i + 1) / 32.0)));
    EXPECT_LT(b.x(), a.x()) << "lightness falls, step " << i;
    total += steps[i] = (b - a).norm();
  }
  for (int i = 0; i < 32; ++i) EXPECT_NEAR(steps[i] / (total / 32), 1, 0.45) << "step " << i;
}

TEST(Palette, DivergingMapIsPaperAtZeroAndAsDarkOnBothSides) {
  EXPECT_EQ(palette::diverging(0), palette::paper);
  for (const double t : {0.2, 0.5, 1.0}) {
    const Vector3d cold = lab(linear(palette::diverging(-t))), warm = lab(linear(palette::diverging(t)));
    EXPECT_NEAR(cold.x(), warm.x(), 6) << t;
    EXPECT_LT(cold.z(), warm.z()) << t;
    for (const Matrix3d& eye : eyes)
      EXPECT_GT((lab(eye * linear(palette::diverging(-t))) - lab(eye * linear(palette::diverging(t)))).norm(),
                30 * t)
          << t;
  }
}

TEST(Palette, MixEndsAtItsColours) {
  const Colour a{10, 200, 30}, b{250, 20, 90, 100};
  EXPECT_EQ(mix(a, b, 0), a);
  EXPECT_EQ(mix(a, b, 1), b);
  EXPECT_EQ(palette::sequential(-3), palette::sequential(0));
  EXPECT_EQ(palette::diverging(7), palette::diverging(1));
  EXPECT_EQ(palette::series(15), palette::series(0));
}

}  // namespace
}  // namespace byhand::renderer
