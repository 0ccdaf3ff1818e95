#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/collide/manifold.hpp"
#include "solver/collide/sweep_and_prune.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// The contacts of a scene from one step to the next: what touches is found from the shapes and written into the
/// scene as constraints; the impulses of contacts that are found again are handed on, so that a warm start has
/// them.
template <class M>
class Touching {
  static constexpr int tangents = M::linear - 1;

  template <class S>
  static constexpr bool makes_faces = [] {
    if constexpr (std::is_same_v<M, PlaneBody>)
      return S::template names<FaceContact>;
    else
      return false;
  }();

  /// Two bodies that touch, body1 < body2: where, by arms in their frames, and the impulses of their points.
  struct Touch {
    static constexpr int capacity = Manifold<M>::capacity;
    int body1, body2;
    int size;
    std::uint32_t reference;  // of the manifold
    int constraint;           // the number of the first that came of it
    std::array<std::uint32_t, capacity> features;
    Linear<M> normal;
    std::array<Arms<M>, capacity> arms;
    std::array<double, capacity> pressed = {};                             // [N s]
    std::array<Eigen::Matrix<double, tangents, 1>, capacity> rubbed = {};  // of a face the first is the whole's
  };

 public:
  /// Looks for contacts at the current poses and makes them the scene's found constraints: one FaceContact for two
  /// bodies if the scene names that kind, else a Contact for each point, with Friction if the scene names it.
  /// Bodies that a constraint joins, and two that do not move, pass through each other. Two bodies that have
  /// hardly moved since they were looked at keep their contact as it is: its arms turn with them.
  template <class S>
  void find(S& scene) {
    if (scene.colliders.shapes.empty()) return;
    const bool stands = version_ == scene.version();
    if (!note_stirred(scene) && stands) return;
    note_joined(scene);
    const auto& bodies = scene.bodies;
    found_.clear();
    bool same = stands;
    auto known = touches_.begin();
    for (const auto& [i, j] : broad_phase_.overlapping(bounds_)) {
      if (!moves(bodies.inverse_mass[i]) && !moves(bodies.inverse_mass[j])) continue;
      if (std::binary_search(joined_.begin(), joined_.end(), std::pair(i, j))) continue;
      while (known != touches_.end() && std::pair(known->body1, known->body2) < std::pair(i, j)) ++known;
      const bool again = known != touches_.end() && known->body1 == i && known->body2 == j;
      if (again && !stirred_[i] && !stirred_[j])
        found_.push_back(*known);
      else if (!look(scene, i, j, again ? &*known : nullptr))
        continue;
      same = same && again && known->size == found_.back().size &&
             known - touches_.begin() == static_cast<std::ptrdiff_t>(found_.size()) - 1;
    }
    std::swap(touches_, found_);
    if (same && touches_.size() == found_.size())
      for (const Touch& touch : touches_) rewrite(touch, scene);
    else
      write_anew(scene);
    version_ = scene.version();
  }

  /// Gives the found rows of the scene, in a System or PositionRows, the impulses that their contacts had.
  template <class S, class AnyRows>
  void write_impulses(AnyRows& rows) const {
    for (const Touch& touch : touches_)
      for_each_row<S>(touch, rows.row_of, [&](int row, double kept) { rows.lambda[row] = kept; });
  }
  /// Keeps the impulses of the found rows for the next step.
  template <class S, class AnyRows>
  void read_impulses(const AnyRows& rows) {
    for (Touch& touch : touches_)
      for_each_row<S>(touch, rows.row_of, [&](int row, double& kept) { kept = rows.lambda[row]; });
  }

 private:
  /// Notes which bodies have moved noticeably since they were last looked at, and where those are now. Returns
  /// whether there are any.
  template <class S>
  bool note_stirred(const S& scene) {
    const auto& shapes = scene.colliders.shapes;
    const double margin = scene.colliders.margin, noticeable = 0.01 * margin;
    const auto known = seen_.size();
    seen_.resize(shapes.size());
    bounds_.resize(shapes.size());
    stirred_.assign(shapes.size(), 0);
    bool any = false;
    for (std::size_t i = 0; i < shapes.size(); ++i) {
      const Pose<M>& pose = scene.bodies.pose[i];
      if (i < known && (!moves(scene.bodies.inverse_mass[i]) || shift(seen_[i], pose, bounds_[i]) < noticeable))
        continue;
      seen_[i] = pose;
      bounds_[i] = fattened(bounds<M>(shapes[i], pose), 0.5 * margin + noticeable);
      stirred_[i] = 1;
      any = true;
    }
    return any;
  }

  /// How far a body's points have moved at most, by its position and by turning what its bounds can hold.
  static double shift(const Pose<M>& before, const Pose<M>& now, const Bounds<M>& bounds) {
    double turned = 0;  // twice the sine of half the angle, or a little more
    if constexpr (M::angular == 1)
      turned =
          Eigen::Vector2d(now.rotation.cos - before.rotation.cos, now.rotation.sin - before.rotation.sin).norm();
    else
      turned = 2 * (now.rotation.coeffs() - before.rotation.coeffs()).norm();
    return (now.position - before.position).norm() + 0.5 * bounds.diagonal().norm() * turned;
  }

  template <class S>
  void note_joined(const S& scene) {
    if (lasting_ == scene.lasting()) return;
    lasting_ = scene.lasting();
    joined_.clear();
    int number = 0;
    scene.for_each([&](const auto& constraint) {
      if (number++ < lasting_) joined_.push_back(std::minmax(constraint.at.body1, constraint.at.body2));
    });
    std::sort(joined_.begin(), joined_.end());
  }

  /// Adds what two bodies have found of each other now; returns whether they touch.
  template <class S>
  bool look(const S& scene, int i, int j, const Touch* before) {
    const auto& [shapes, surfaces, margin] = scene.colliders;
    const Pose<M>&pose1 = scene.bodies.pose[i], &pose2 = scene.bodies.pose[j];
    const Manifold<M> manifold =
        touch<M>(shapes[i], pose1, shapes[j], pose2, margin, before ? before->reference : 0);
    if (manifold.empty()) return false;
    Touch& now = found_.emplace_back();
    now.body1 = i;
    now.body2 = j;
    now.size = manifold.size;
    now.reference = manifold.reference;
    now.normal = manifold.normal;
    for (int p = 0; p < manifold.size; ++p) {
      now.features[p] = manifold.points[p].feature;
      now.arms[p] = {arm_to<M>(pose1, manifold.points[p].p1), arm_to<M>(pose2, manifold.points[p].p2)};
    }
    if (before) hand_on(*before, now);
    return true;
  }

  /// λ of points that are the same as before; friction is turned into the new tangents.
  static void hand_on(const Touch& before, Touch& now) {
    now.constraint = before.constraint;
    const auto turn = (tangents_of<M>(now.normal).transpose() * tangents_of<M>(before.normal)).eval();
    now.rubbed[0] = turn * before.rubbed[0];
    for (int p = 0; p < now.size; ++p)
      for (int q = 0; q < before.size; ++q)
        if (now.features[p] == before.features[q]) {
          now.pressed[p] = before.pressed[q];
          now.rubbed[p] = turn * before.rubbed[q];
        }
  }

  template <class S>
  void write_anew(S& scene) {
    scene.forget_found();
    for (Touch& touch : touches_) {
      touch.constraint = scene.count();
      for_each_constraint(touch, scene, [&](const auto& constraint) { return scene.add_found(constraint); });
    }
  }
  template <class S>
  void rewrite(const Touch& touch, S& scene) {
    if (!stirred_[touch.body1] && !stirred_[touch.body2]) return;
    int number = touch.constraint;
    for_each_constraint(touch, scene, [&]<template <class> class Kind>(const Kind<M>& constraint) {
      scene.template at<Kind>(number) = constraint;
      return number++;
    });
  }

  /// Calls put(constraint) for each constraint that comes of a touch; it returns the number that this one has.
  template <class S, class Put>
  static void for_each_constraint(const Touch& touch, const S& scene, Put&& put) {
    if constexpr (makes_faces<S>) {
      put(face(touch, scene));
    } else {
      for (int p = 0; p < touch.size; ++p) {
        const int leader = put(contact(touch, p, scene));
        if constexpr (S::template names<Friction>) put(friction(touch, p, leader, scene));
      }
    }
  }

  /// Calls f(row, impulse) for each row that came of a touch.
  template <class S, class AnyTouch, class F>
  static void for_each_row(AnyTouch& touch, const std::vector<int>& row_of, F&& f) {
    int constraint = touch.constraint;
    if constexpr (makes_faces<S>) {
      const int row = row_of[constraint];
      f(row, touch.pressed[0]);
      f(row + 1, touch.pressed[1]);
      f(row + 2, touch.rubbed[0][0]);
    } else {
      for (int p = 0; p < touch.size; ++p) {
        f(row_of[constraint++], touch.pressed[p]);
        if constexpr (S::template names<Friction>) {
          for (int k = 0; k < tangents; ++k) f(row_of[constraint] + k, touch.rubbed[p][k]);
          ++constraint;
        }
      }
    }
  }

  template <class S>
  static double friction_of(const Touch& touch, const S& scene) {
    const auto& surfaces = scene.colliders.surfaces;
    return std::sqrt(surfaces[touch.body1].friction * surfaces[touch.body2].friction);
  }
  template <class S>
  static double restitution_of(const Touch& touch, const S& scene) {
    const auto& surfaces = scene.colliders.surfaces;
    return std::max(surfaces[touch.body1].restitution, surfaces[touch.body2].restitution);
  }

  template <class S>
  static FaceContact<M> face(const Touch& touch, const S& scene) {
    FaceContact<M> face;
    face.at = {touch.body1, touch.body2, touch.arms[0]};
    face.point = touch.size == 1;
    face.second = touch.arms[1];
    face.normal = touch.normal;
    face.coefficient = friction_of(touch, scene);
    face.restitution = restitution_of(touch, scene);
    return face;
  }
  template <class S>
  static Contact<M> contact(const Touch& touch, int p, const S& scene) {
    Contact<M> contact{{touch.body1, touch.body2, touch.arms[p]}, touch.normal};
    contact.restitution = restitution_of(touch, scene);
    return contact;
  }
  template <class S>
  static Friction<M> friction(const Touch& touch, int p, int leader, const S& scene) {
    return {{touch.body1, touch.body2, touch.arms[p]},
            tangents_of<M>(touch.normal),
            friction_of(touch, scene),
            leader};
  }

  SweepAndPrune<M::linear> broad_phase_;
  std::vector<Pose<M>> seen_;  // of each body when it was last looked at
  std::vector<Bounds<M>> bounds_;
  std::vector<char> stirred_;
  std::vector<std::pair<int, int>> joined_;
  std::vector<Touch> touches_, found_;
  int lasting_ = -1, version_ = -1;
};

/// What scenes have in its place in which nothing can touch.
struct NoTouching {};

}  // namespace byhand
