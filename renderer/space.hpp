#pragma once

#include <array>
#include <optional>
#include <vector>

#include "renderer/palette.hpp"
#include "renderer/rectangle.hpp"

namespace byhand::renderer {

/// A rotation as a unit quaternion. Converts from any type with these four accessors, such as Eigen::Quaterniond.
struct Quaternion {
  double w = 1, x = 0, y = 0, z = 0;

  constexpr Quaternion() = default;
  constexpr Quaternion(double w_, double x_, double y_, double z_) : w(w_), x(x_), y(y_), z(z_) {}
  template <class Q>
  requires requires(const Q& q) { q.w(), q.x(), q.y(), q.z(); }
  constexpr Quaternion(const Q& q) : Quaternion(q.w(), q.x(), q.y(), q.z()) {}
};

/// A perspective camera in space.
struct SpaceCamera {
  Rectangle frame{};  ///< on the page, in points
  Point3 eye{6, -8, 4};
  Point3 target{0, 0, 0};
  Point3 up{0, 0, 1};
  double field_of_view = 0.5;  ///< vertical angle of view [rad]
};

/// The camera that sees the whole ball around `centre` in `frame` along `direction`, which need not be a unit
/// vector.
SpaceCamera fit(const Point3& centre, double radius, const Point3& direction, const Rectangle& frame,
                const Point3& up = {0, 0, 1});

/// A lit scene of solids in space. Draw it with `Canvas::draw`.
class Space {
 public:
  /// Throws std::invalid_argument if the eye is at the target, looks along `up`, or the frame is empty.
  explicit Space(const SpaceCamera& camera);

  void sphere(const Point3& centre, double radius, Colour colour);
  void box(const Point3& centre, const Point3& size, const Quaternion& orientation, Colour colour);
  /// A capsule.
  void rod(const Point3& a, const Point3& b, double radius, Colour colour);
  void path(const std::vector<Point3>& points, double radius, Colour colour);
  /// A shaft and a cone with its tip at `to`.
  void arrow(const Point3& from, const Point3& to, double radius, Colour colour);
  /// A plane through `centre` at right angles to `up`, with grid lines `spacing` apart, soft shadows, and fading
  /// at the distance `extent`. At most one.
  void ground(const Point3& centre, double extent, double spacing = 1);

  /// Position of a point on the page, in points.
  Point project(const Point3& point) const;
  /// Points on the page per unit of length, at this depth.
  double scale_at(const Point3& point) const;
  const SpaceCamera& camera() const { return camera_; }

 private:
  friend class Painter;
  struct Vertex {
    std::array<float, 3> position, normal;
    Colour colour;
  };
  using Homogeneous = std::array<double, 4>;  // x, y, z, w
  struct Ground {
    Point3 centre;
    double extent, spacing;
  };
  void surface(const std::vector<Point3>& profile, const Point3& from, const Point3& to, Colour colour);
  void triangle(const std::array<Point3, 3>& corners, const std::array<Point3, 3>& normals, Colour colour);

  Homogeneous to_clip(const Point3& point) const;

  SpaceCamera camera_;
  std::array<Homogeneous, 4> matrix_;  // columns; world to clip coordinates
  std::vector<Vertex> triangles_;
  std::optional<Ground> ground_;
};

}  // namespace byhand::renderer
