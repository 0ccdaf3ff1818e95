#include "lessons/pictures/faces.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>

namespace byhand::pictures {

using namespace renderer;
using Eigen::Vector3d;

Seen<SpaceBody> seen_from_aside(double turned, double raised) {
  const Eigen::RowVector3d right(std::cos(turned), 0, -std::sin(turned)),
      towards(std::cos(raised) * std::sin(turned), std::sin(raised), std::cos(raised) * std::cos(turned));
  Seen<SpaceBody> seen;
  seen.row(0) = right;
  seen.row(1) = towards.cross(right);
  return seen;
}

Faces::Faces(const Seen<SpaceBody>& seen) : seen_(seen) {
  const Eigen::Vector3d right = seen.row(0), up = seen.row(1);
  towards_ = right.cross(up);
  light_ = (1.2 * up - 0.6 * right + 0.8 * towards_).normalized();
}

void Faces::add(Solid& solid, const std::vector<Vector3d>& corners, const Vector3d& normal, Colour colour) const {
  if (normal.dot(towards_) <= 0) return;
  Face face{{}, mix(palette::ink, colour, 0.7 + 0.3 * std::max(0.0, normal.dot(light_)))};
  for (const Vector3d& corner : corners) face.corners.emplace_back(Eigen::Vector2d(seen_ * corner));
  solid.faces.push_back(std::move(face));
}

void Faces::box(const Pose<SpaceBody>& pose, const Vector3d& middle, const Vector3d& sides, Colour colour) {
  const Eigen::Matrix3d axes = pose.rotation.toRotationMatrix();
  const auto in_world = [&](const Vector3d& point) { return Vector3d(pose.position + axes * point); };
  Solid solid{in_world(middle).dot(towards_), {}};
  for (int axis = 0; axis < 3; ++axis)
    for (const double side : {-1, 1}) {
      const Vector3d n = side * Vector3d::Unit(axis), u = Vector3d::Unit((axis + 1) % 3),
                     v = Vector3d::Unit((axis + 2) % 3);
      std::vector<Vector3d> corners;
      for (const auto& [i, j] : {std::pair{-1, -1}, {1, -1}, {1, 1}, {-1, 1}})
        corners.push_back(in_world(middle + 0.5 * sides.cwiseProduct(n + i * u + j * v)));
      add(solid, corners, axes * n, colour);
    }
  solids_.push_back(std::move(solid));
}

void Faces::cylinder(const Pose<SpaceBody>& pose, const Vector3d& from, const Vector3d& to, double radius,
                     Colour colour) {
  constexpr int sides = 24;
  const Eigen::Matrix3d axes = pose.rotation.toRotationMatrix();
  const auto in_world = [&](const Vector3d& point) { return Vector3d(pose.position + axes * point); };
  const Vector3d along = (to - from).normalized(), u = along.unitOrthogonal(), v = along.cross(u);
  const auto out = [&](double side) {
    const double angle = 2 * std::numbers::pi * side / sides;
    return Vector3d(std::cos(angle) * u + std::sin(angle) * v);
  };
  Solid solid{in_world(0.5 * (from + to)).dot(towards_), {}};
  std::vector<Vector3d> first, last;
  for (int i = 0; i < sides; ++i) {
    const Vector3d here = radius * out(i), next = radius * out(i + 1);
    first.push_back(in_world(from + here));
    last.push_back(in_world(to + here));
    add(solid, {first.back(), in_world(from + next), in_world(to + next), last.back()}, axes * out(i + 0.5),
        colour);
  }
  add(solid, first, axes * -along, colour);
  add(solid, last, axes * along, colour);
  solids_.push_back(std::move(solid));
}

std::vector<Faces::Face> Faces::in_order() const {
  std::vector<Solid> order = solids_;
  std::stable_sort(order.begin(), order.end(),
                   [](const Solid& one, const Solid& other) { return one.depth < other.depth; });
  std::vector<Face> all;
  for (const Solid& solid : order) all.insert(all.end(), solid.faces.begin(), solid.faces.end());
  return all;
}

void draw(Canvas& canvas, const Faces& faces) {
  for (const Faces::Face& face : faces.in_order())
    canvas.polygon(face.corners, {face.colour, {face.colour, 1}});  // an edge, or gaps would be seen between them
}

void add_book(Faces& faces, const Pose<SpaceBody>& pose, const Vector3d& sides) {
  constexpr double share = 0.22;  // of the coloured end
  const auto part = [&](double low, double high, Colour colour) {
    faces.box(pose, {0, 0.5 * (low + high) * sides.y(), 0}, {sides.x(), (high - low) * sides.y(), sides.z()},
              colour);
  };
  part(-0.5, 0.5 - share, palette::body);
  part(0.5 - share, 0.5, palette::highlight);
}

}  // namespace byhand::pictures
