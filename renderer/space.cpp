#include "renderer/space.hpp"

#include <cmath>
#include <numbers>
#include <stdexcept>

namespace byhand::renderer {
namespace {

constexpr int sides = 48;  // of everything round
constexpr double pi = std::numbers::pi;

// A frame of three axes whose third is `axis`.
Eigen::Matrix3d frame_along(const Point3& axis) {
  Eigen::Matrix3d frame;
  frame.col(2) = axis;
  frame.col(0) = axis.unitOrthogonal();
  frame.col(1) = axis.cross(Point3(frame.col(0)));
  return frame;
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
  const double distance = ahead.norm(), near = distance / 20, far = distance * 20;
  Eigen::Matrix3d axes;
  axes.row(0) = right.normalized();
  axes.row(1) = right.cross(ahead).normalized();
  axes.row(2) = -ahead / distance;
  Eigen::Matrix4d view = Eigen::Matrix4d::Identity();
  view.topLeftCorner<3, 3>() = axes;
  view.topRightCorner<3, 1>() = -axes * camera.eye;
  Eigen::Matrix4d perspective = Eigen::Matrix4d::Zero();
  const double zoom = 1 / std::tan(camera.field_of_view / 2);
  perspective(0, 0) = zoom * camera.frame.height / camera.frame.width;
  perspective(1, 1) = zoom;
  perspective(2, 2) = (near + far) / (near - far);
  perspective(2, 3) = 2 * near * far / (near - far);
  perspective(3, 2) = -1;
  matrix_ = perspective * view;
}

Point Space::project(const Point3& point) const {
  const Eigen::Vector4d clip = matrix_ * point.homogeneous();
  const Point unit = clip.head<2>() / clip.w();
  return camera_.frame.centre() + 0.5 * unit.cwiseProduct(Point(camera_.frame.width, camera_.frame.height));
}

double Space::scale_at(const Point3& point) const {
  const double depth = (matrix_ * point.homogeneous()).w();
  return camera_.frame.height / (2 * std::tan(camera_.field_of_view / 2) * depth);
}

void Space::triangle(const std::array<Point3, 3>& corners, const std::array<Point3, 3>& normals, Colour colour) {
  for (int i = 0; i < 3; ++i) {
    const Eigen::Vector3f p = corners[i].cast<float>(), n = normals[i].cast<float>();
    triangles_.push_back({{p.x(), p.y(), p.z()}, {n.x(), n.y(), n.z()}, colour});
  }
}

// A surface of revolution about the way from `from` to `to`. Each stop of the profile gives the distance from
// the axis, the height along it and the slope of the normal: its share outward is cos, along the axis sin of
// the third.
void Space::surface(const std::vector<Point3>& profile, const Point3& from, const Point3& to, Colour colour) {
  const Point3 axis = to - from;
  const Eigen::Matrix3d frame = frame_along(axis.norm() > 0 ? Point3(axis.normalized()) : Point3(0, 0, 1));
  const auto at = [&](const Point3& stop, int side) -> std::pair<Point3, Point3> {
    const double angle = 2 * pi * side / sides;
    const Point3 out = frame * Point3(std::cos(angle), std::sin(angle), 0);
    return {from + stop.x() * out + stop.y() * frame.col(2),
            std::cos(stop.z()) * out + std::sin(stop.z()) * frame.col(2)};
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

void Space::box(const Point3& centre, const Point3& size, const Eigen::Quaterniond& orientation, Colour colour) {
  const Eigen::Matrix3d turn = orientation.toRotationMatrix();
  for (int axis = 0; axis < 3; ++axis) {
    for (const double sign : {-1.0, 1.0}) {
      Point3 n = Point3::Zero(), u = Point3::Zero(), v = Point3::Zero();
      n[axis] = sign, u[(axis + 1) % 3] = 1, v[(axis + 2) % 3] = 1;
      const auto corner = [&](double i, double j) -> Point3 {
        return centre + turn * (0.5 * size.cwiseProduct(n + i * u + j * v));
      };
      const Point3 normal = turn * n;
      triangle({corner(-1, -1), corner(1, -1), corner(1, 1)}, {normal, normal, normal}, colour);
      triangle({corner(-1, -1), corner(1, 1), corner(-1, 1)}, {normal, normal, normal}, colour);
    }
  }
}

void Space::ground(const Point3& centre, double extent, double spacing) {
  ground_ = Ground{centre, extent, spacing};
}

}  // namespace byhand::renderer
