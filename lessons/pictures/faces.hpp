#pragma once

#include <vector>

#include "lessons/pictures/step_terms.hpp"
#include "renderer/canvas.hpp"

namespace byhand::pictures {

/// The directions `Seen` by a viewer far away, `turned` [rad] to the right of the z axis and `raised` [rad] above
/// the level; y is up.
Seen<SpaceBody> seen_from_aside(double turned, double raised);

/// Convex solids in space as polygons of a canvas, which needs no GPU. Those behind are drawn first, in the order
/// of their middles: right for solids that lie side by side along a line.
class Faces {
 public:
  explicit Faces(const Seen<SpaceBody>& seen);

  /// A box with full side lengths `sides` [m] whose middle lies at `middle` in the body's axes [m].
  void box(const Pose<SpaceBody>& pose, const Eigen::Vector3d& middle, const Eigen::Vector3d& sides,
           renderer::Colour colour);
  /// A cylinder of `radius` [m] from `from` to `to` in the body's axes [m].
  void cylinder(const Pose<SpaceBody>& pose, const Eigen::Vector3d& from, const Eigen::Vector3d& to, double radius,
                renderer::Colour colour);

  struct Face {
    std::vector<renderer::Point> corners;  // in the picture [m]
    renderer::Colour colour;
  };
  /// Those that the viewer sees, the farthest first.
  std::vector<Face> in_order() const;

 private:
  struct Solid {
    double depth;  // of its middle, growing towards the viewer [m]
    std::vector<Face> faces;
  };
  /// A side that the viewer sees; any other is left out.
  void add(Solid& solid, const std::vector<Eigen::Vector3d>& corners, const Eigen::Vector3d& normal,
           renderer::Colour colour) const;

  Seen<SpaceBody> seen_;
  Eigen::Vector3d towards_, light_;  // the viewer, the lamp
  std::vector<Solid> solids_;
};

void draw(renderer::Canvas& canvas, const Faces& faces);

/// A book as that of space_scene.hpp.
void add_book(Faces& faces, const Pose<SpaceBody>& pose, const Eigen::Vector3d& sides);

}  // namespace byhand::pictures
