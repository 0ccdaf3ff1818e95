#include "lessons/pictures/faces.hpp"

#include <gtest/gtest.h>

#include <cmath>
#include <numbers>

namespace byhand::pictures {
namespace faces_test {

constexpr renderer::Colour grey = renderer::palette::body;
const double diagonal = std::asin(1 / std::sqrt(3.0));  // how far a cube's diagonal is raised

/// By the shoelace formula, of all that is drawn [m²].
double area(const Faces& faces) {
  double all = 0;
  for (const Faces::Face& face : faces.in_order()) {
    double twice = 0;
    for (std::size_t i = 0; i < face.corners.size(); ++i) {
      const renderer::Point &a = face.corners[i], &b = face.corners[(i + 1) % face.corners.size()];
      twice += a.x() * b.y() - b.x() * a.y();
    }
    all += 0.5 * std::abs(twice);
  }
  return all;
}

TEST(Faces, TheDirectionsSeenAreUnitVectorsAtRightAngles) {
  const auto seen = seen_from_aside(0.7, 0.4);
  EXPECT_TRUE((seen * seen.transpose()).isIdentity(1e-15)) << seen;
  EXPECT_NEAR(seen(1, 1), std::cos(0.4), 1e-15);  // y is up
}

TEST(Faces, OfABoxSeenStraightOnlyOneSideIsDrawn) {
  Faces faces(seen_from_aside(0, 0));
  faces.box({}, {0, 0, 0}, {1.2, 0.8, 0.2}, grey);
  EXPECT_EQ(faces.in_order().size(), 1u);
  EXPECT_NEAR(area(faces), 1.2 * 0.8, 1e-12);
}

TEST(Faces, ACubeSeenAlongItsDiagonalShowsThreeSidesAndCoversTheRootOfThree) {
  Faces faces(seen_from_aside(std::numbers::pi / 4, diagonal));
  faces.box({}, {0.3, -0.2, 0.1}, {1, 1, 1}, grey);
  EXPECT_EQ(faces.in_order().size(), 3u);
  EXPECT_NEAR(area(faces), std::sqrt(3.0), 1e-12);
}

TEST(Faces, ACylinderSeenAlongItsAxisIsItsLid) {
  Faces faces(seen_from_aside(0, 0));
  faces.cylinder({}, {0, 0, -1}, {0, 0, 1}, 0.5, grey);
  EXPECT_NEAR(area(faces), 12 * 0.25 * std::sin(std::numbers::pi / 12), 1e-12);  // 24 triangles
}

TEST(Faces, WhatIsNearerIsDrawnLater) {
  Faces faces(seen_from_aside(0, 0));
  faces.box({}, {0, 0, 1}, {1, 1, 1}, renderer::palette::highlight);
  faces.box({}, {0, 0, 0}, {2, 1, 1}, grey);
  EXPECT_EQ(std::abs(faces.in_order().back().corners[0].x()), 0.5);
}

}  // namespace faces_test
}  // namespace byhand::pictures
