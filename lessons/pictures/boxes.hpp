#pragma once

#include <cmath>
#include <vector>

#include "renderer/canvas.hpp"
#include "solver/step.hpp"

namespace byhand::pictures {

/// What a scene of shapes in the plane looks like at one instant: a value, so that a figure or a frame can be
/// drawn later, when the scene has moved on. Fixed bodies have their own look; each body's can be changed.
struct Shapes {
  struct Box {
    int body;
    renderer::Point at, size;  // [m]
    double angle;              // [rad]
    renderer::Look look;
  };
  struct Disc {
    int body;
    renderer::Point at;
    double radius, angle;  // [m], [rad]
    renderer::Look look;
  };
  struct Ground {
    renderer::Point at, normal;  // the normal points out of the solid
  };
  std::vector<Box> boxes = {};
  std::vector<Disc> discs = {};
  std::vector<Ground> grounds = {};
};

/// What the first body of a contact gives the second at a point.
struct Push {
  renderer::Point at, impulse;  // [m], [N s]
};

/// Reads the shapes off a scene.
template <class S>
Shapes shapes_of(const S& scene) {
  using M = typename S::model;
  static_assert(M::linear == 2, "a picture in the plane");
  Shapes shapes;
  const auto& [all, surfaces, margin] = scene.colliders;
  for (int i = 0; i < static_cast<int>(all.size()); ++i) {
    const Pose<M>& pose = scene.bodies().pose[i];
    const double angle = std::atan2(pose.rotation.sin, pose.rotation.cos);
    const renderer::Look look = moves(scene.bodies().inverse_mass[i]) ? renderer::body_look : renderer::fixed_look;
    if (const auto* box = std::get_if<byhand::Box<M>>(&all[i]))
      shapes.boxes.push_back({i, pose.position, 2 * box->half, angle, look});
    if (const auto* ball = std::get_if<Ball<M>>(&all[i]))
      shapes.discs.push_back({i, pose.position, ball->radius, angle, look});
    if (const auto* ground = std::get_if<HalfSpace<M>>(&all[i]))
      shapes.grounds.push_back({pose.position, rotate(pose.rotation, ground->normal)});
  }
  return shapes;
}

/// The impulses of a scene's contacts as its last step left them, normal and friction together, at the points
/// where they act: a face's friction at both its ends, in proportion to what they press.
template <class S>
std::vector<Push> pushes(const S& scene, const System<typename S::model>& system) {
  using M = typename S::model;
  std::vector<Push> pushes;
  int number = 0;
  scene.for_each([&]<class Kind>(const Kind& constraint) {
    const int row = system.row_of[number++];
    const auto point = [&](const Arm<M>& arm) {
      const Pose<M>& pose = scene.bodies().pose[constraint.at.body2];
      return renderer::Point(anchor<M, double>(pose, in_world<M, double>(pose, arm)));
    };
    if constexpr (std::is_same_v<Kind, Contact<M>>)
      pushes.push_back({point(constraint.at.arms.second), system.lambda[row] * constraint.normal});
    if constexpr (std::is_same_v<Kind, Friction<M>>)
      pushes.push_back({point(constraint.at.arms.second), system.lambda[row] * constraint.tangents.col(0)});
    if constexpr (std::is_same_v<Kind, ContactManifold<M>>) {
      const double first = system.lambda[row], second = system.lambda[row + 1], both = first + second;
      if (both <= 0) return;
      const Linear<M> n = constraint.normal, t(n.y(), -n.x());
      const Linear<M> unit = n + system.lambda[row + 2] / both * t;
      pushes.push_back({point(constraint.at.arms.second), first * unit});
      if (!constraint.point) pushes.push_back({point(constraint.second.second), second * unit});
    }
  });
  return pushes;
}

/// Draws shapes in the world of the canvas's camera; the ground reaches to the edges of what it sees.
void draw(renderer::Canvas& canvas, const Shapes& shapes);

/// Draws impulses as arrows from where they act.
void draw(renderer::Canvas& canvas, const std::vector<Push>& pushes, const renderer::ArrowKind& kind);

}  // namespace byhand::pictures
