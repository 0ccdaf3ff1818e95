#include "lessons/pictures/space_scene.hpp"

#include <Eigen/Geometry>
#include <cmath>
#include <numbers>

namespace byhand::pictures {

using namespace renderer;

SpaceCamera from_aside(const Point3& centre, double radius, const Rectangle& frame, double turned, double raised) {
  const Point3 towards(std::cos(raised) * std::sin(turned), std::sin(raised), std::cos(raised) * std::cos(turned));
  return fit(centre, radius, -towards, frame, Point3::UnitY());
}

void add_book(Space& space, const Pose<SpaceBody>& pose, const Point3& sides, Colour colour) {
  constexpr double share = 0.22;  // of the coloured end
  const auto part = [&](double low, double high, Colour of_it) {
    const Eigen::Vector3d middle(0, 0.5 * (low + high) * sides.y(), 0);
    const Point3 size(sides.x(), (high - low) * sides.y(), sides.z());
    space.box(pose.position + rotate(pose.rotation, middle), size, pose.rotation, of_it);
  };
  part(-0.5, 0.5 - share, colour);
  part(0.5 - share, 0.5, palette::highlight);
}

namespace {

/// A thin square bar: a cheap line. Bars with the same `side` are shaded alike.
void add_bar(Space& space, const Point3& a, const Point3& b, const Point3& side, double thickness, Colour colour) {
  const Eigen::Vector3d way = b - a, across = side.cross(way);
  Eigen::Matrix3d axes;
  axes.col(0) = way.normalized();
  axes.col(1) = across.norm() > 1e-9 * way.norm() ? across.normalized() : axes.col(0).unitOrthogonal();
  axes.col(2) = axes.col(0).cross(axes.col(1));
  space.box(0.5 * (a + b), {way.norm() + 0.1 * thickness, thickness, thickness}, Eigen::Quaterniond(axes), colour);
}

}  // namespace

void add_trail(Space& space, const std::vector<Point3>& points, double thickness, Colour colour) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double age = 1 - static_cast<double>(i + 1) / static_cast<double>(points.size());
    add_bar(space, points[i], points[i + 1], Point3::UnitY(), thickness, mix(colour, palette::paper, 0.9 * age));
  }
}

void add_ring(Space& space, const Point3& centre, const Point3& axis, double radius, double thickness,
              Colour colour) {
  constexpr int segments = 72;
  const Point3 first = axis.unitOrthogonal(), second = axis.cross(first);
  const auto at = [&](int i) {
    const double angle = 2 * std::numbers::pi * i / segments;
    return centre + radius * (std::cos(angle) * first + std::sin(angle) * second);
  };
  for (int i = 0; i < segments; ++i) add_bar(space, at(i), at(i + 1), axis, thickness, colour);
}

}  // namespace byhand::pictures
