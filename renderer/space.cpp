#include "renderer/space.hpp"

#include <algorithm>
#include <cmath>
#include <numbers>
#include <stdexcept>
#include <utility>

namespace byhand::renderer {
namespace {

constexpr int sides = 48;  // segments of a circle
constexpr double pi = std::numbers::pi;

using Axes = std::array<Point3, 3>;

// The vector with these components along the axes.
Point3 along(const Axes& axes, const Point3& v) { return v.x() * axes[0] + v.y() * axes[1] + v.z() * axes[2]; }

// Three axes at right angles, the third along the unit vector `axis`.
Axes axes_with_third(const Point3& axis) {
  const Point3 first = axis.unitOrthogonal();
  return {first, axis.cross(first), axis};
}

// The axes of a rotated frame: the columns of its rotation matrix.
Axes axes_of(const Quaternion& q) {
  const double x = 2 * q.x, y = 2 * q.y, z = 2 * q.z;
  return {Point3(1 - (y * q.y + z * q.z), y * q.x + z * q.w, z * q.x - y * q.w),
          Point3(y * q.x - z * q.w, 1 - (x * q.x + z * q.z), z * q.y + x * q.w),
          Point3(z * q.x + y * q.w, z * q.y - x * q.w, 1 - (x * q.x + y * q.y))};
}

}  // namespace

SpaceCamera fit(const Point3& centre, double radius, const Point3& direction, const Rectangle& frame,
                const Point3& up) {
  SpaceCamera camera{.frame = frame, .target = centre, .up = up};
  const double half_height = std::tan(camera.field_of_view / 2);
  const double half_angle = std::atan(half_height * std::min(1.0, frame.width / frame.height));
  camera.eye = centre - direction.normalized() * (radius / std::sin(half_angle));
  return camera;
}

Space::Space(const SpaceCamera& camera) : camera_(camera) {
  const Point3 ahead = camera.target - camera.eye;
  const Point3 right = ahead.cross(camera.up);
  const bool frame = camera.frame.width > 0 && camera.frame.height > 0;
  const bool angle = camera.field_of_view > 0 && camera.field_of_view < pi;
  if (!(frame && angle && ahead.allFinite() && right.norm() > 1e-9 * ahead.norm() * camera.up.norm()))
    throw std::invalid_argument(
        "A camera in space needs a frame with an area, a field of view between 0 and π, and a target away "
        "from the "
        "eye and not straight along up.");
  // Perspective after view: the view's rows are the camera's axes, with the eye at its origin.
  const double distance = ahead.norm(), near = distance / 20, far = distance * 20;
  const Axes axes{right.normalized(), right.cross(ahead).normalized(), -ahead / distance};
  const Point3 eye(-axes[0].dot(camera.eye), -axes[1].dot(camera.eye), -axes[2].dot(camera.eye));
  const double zoom = 1 / std::tan(camera.field_of_view / 2);
  const double wide = zoom * camera.frame.height / camera.frame.width;
  const double depth = (near + far) / (near - far), depth_offset = 2 * near * far / (near - far);
  for (int i = 0; i < 3; ++i) matrix_[i] = {wide * axes[0][i], zoom * axes[1][i], depth * axes[2][i], -axes[2][i]};
  matrix_[3] = {wide * eye.x(), zoom * eye.y(), depth * eye.z() + depth_offset, -eye.z()};
}

Space::Homogeneous Space::to_clip(const Point3& point) const {
  Homogeneous clip{};
  for (int i = 0; i < 4; ++i)
    clip[i] = matrix_[0][i] * point.x() + matrix_[1][i] * point.y() + matrix_[2][i] * point.z() + matrix_[3][i];
  return clip;
}

Point Space::project(const Point3& point) const {
  const auto [x, y, z, w] = to_clip(point);
  return camera_.frame.centre() + 0.5 * Point(x / w * camera_.frame.width, y / w * camera_.frame.height);
}

double Space::scale_at(const Point3& point) const {
  return camera_.frame.height / (2 * std::tan(camera_.field_of_view / 2) * to_clip(point)[3]);
}

void Space::triangle(const std::array<Point3, 3>& corners, const std::array<Point3, 3>& normals, Colour colour) {
  for (int i = 0; i < 3; ++i) {
    const auto floats = [](const Point3& v) -> std::array<float, 3> {
      return {float(v.x()), float(v.y()), float(v.z())};
    };
    triangles_.push_back({floats(corners[i]), floats(normals[i]), colour});
  }
}

// A surface of revolution about the axis from `from` to `to`. Each point of the profile holds the distance from
// the axis, the height along it and the angle [rad] of the normal towards the axis direction.
void Space::surface(const std::vector<Point3>& profile, const Point3& from, const Point3& to, Colour colour) {
  const Point3 axis = to - from;
  const Axes axes = axes_with_third(axis.norm() > 0 ? axis.normalized() : Point3::UnitZ());
  const auto at = [&](const Point3& stop, int side) -> std::pair<Point3, Point3> {
    const double angle = 2 * pi * side / sides;
    const Point3 out = along(axes, {std::cos(angle), std::sin(angle), 0});
    return {from + stop.x() * out + stop.y() * axes[2], std::cos(stop.z()) * out + std::sin(stop.z()) * axes[2]};
  };
  for (std::size_t i = 0; i + 1 < profile.size(); ++i) {
    for (int side = 0; side < sides; ++side) {
      const auto [a, an] = at(profile[i], side);
      const auto [b, bn] = at(profile[i], side + 1);
      const auto [c, cn] = at(profile[i + 1], side + 1);
      const auto [d, dn] = at(profile[i + 1], side);
      triangle({a, b, c}, {an, bn, cn}, colour);
      triangle({a, c, d}, {an, cn, dn}, colour);
    }
  }
}

void Space::sphere(const Point3& centre, double radius, Colour colour) { rod(centre, centre, radius, colour); }

void Space::rod(const Point3& a, const Point3& b, double radius, Colour colour) {
  constexpr int quarter = sides / 4;
  const double length = (b - a).norm();
  std::vector<Point3> profile;
  for (int i = -quarter; i <= quarter; ++i) {
    const double latitude = pi / 2 * i / quarter;
    const Point3 stop(radius * std::cos(latitude), radius * std::sin(latitude), latitude);
    if (i <= 0) profile.push_back(stop);
    if (i >= 0) profile.push_back(stop + Point3(0, length, 0));
  }
  surface(profile, a, b, colour);
}

void Space::path(const std::vector<Point3>& points, double radius, Colour colour) {
  for (std::size_t i = 0; i + 1 < points.size(); ++i) rod(points[i], points[i + 1], radius, colour);
}

void Space::arrow(const Point3& from, const Point3& to, double radius, Colour colour) {
  const double length = (to - from).norm(), head = std::min(length, 6 * radius), neck = length - head;
  const double slope = std::atan2(2.4 * radius, head);
  surface({{0, 0, -pi / 2}, {radius, 0, -pi / 2}}, from, to, colour);
  surface({{radius, 0, 0}, {radius, neck, 0}}, from, to, colour);
  surface({{radius, neck, -pi / 2}, {2.4 * radius, neck, -pi / 2}}, from, to, colour);
  surface({{2.4 * radius, neck, slope}, {0, length, slope}}, from, to, colour);
}

void Space::box(const Point3& centre, const Point3& size, const Quaternion& orientation, Colour colour) {
  const Axes axes = axes_of(orientation);
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      const Point3 n = sign * Point3::Unit(axis), u = Point3::Unit((axis + 1) % 3),
                   v = Point3::Unit((axis + 2) % 3);
      const auto corner = [&](double i, double j) -> Point3 {
        return centre + along(axes, 0.5 * size.cwiseProduct(n + i * u + j * v));
      };
      const Point3 normal = along(axes, n);
      triangle({corner(-1, -1), corner(1, -1), corner(1, 1)}, {normal, normal, normal}, colour);
      triangle({corner(-1, -1), corner(1, 1), corner(-1, 1)}, {normal, normal, normal}, colour);
    }
  }
}

void Space::ground(const Point3& centre, double extent, double spacing) {
  ground_ = Ground{centre, extent, spacing};
}

}  // namespace byhand::renderer
