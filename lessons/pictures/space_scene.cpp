#include "lessons/pictures/space_scene.hpp"

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
    const Point3 middle(0, 0.5 * (low + high) * sides.y(), 0),
        size(sides.x(), (high - low) * sides.y(), sides.z());
    space.box(pose.position + rotate(pose.rotation, middle), size, pose.rotation, of_it);
  };
  part(-0.5, 0.5 - share, colour);
  part(0.5 - share, 0.5, palette::highlight);
}

void add_trail(Space& space, const std::vector<Point3>& points, double radius, Colour colour) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) {
    const double age = 1 - static_cast<double>(i + 1) / static_cast<double>(points.size());
    space.rod(points[i], points[i + 1], radius, mix(colour, palette::paper, 0.9 * age));
  }
}

void add_ring(Space& space, const Point3& centre, double radius, double thickness, Colour colour) {
  constexpr int segments = 48;
  std::vector<Point3> points;
  for (int i = 0; i <= segments; ++i) {
    const double angle = 2 * std::numbers::pi * i / segments;
    points.push_back(centre + radius * Point3(std::cos(angle), 0, std::sin(angle)));
  }
  space.path(points, thickness / 2, colour);
}

}  // namespace byhand::pictures
