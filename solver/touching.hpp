#pragma once

#include <algorithm>
#include <array>
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

  /// Two bodies that touch, body1 < body2, and the impulses of their points.
  struct Touch {
    int body1, body2;
    Manifold<M> manifold;
    std::array<double, Manifold<M>::capacity> normal = {};  // [N s]
    std::array<Eigen::Matrix<double, tangents, 1>, Manifold<M>::capacity>
        slip;            // of a face the first is the whole's
    int constraint = 0;  // the number of the first that came of it
  };

 public:
  /// Looks for contacts at the current poses and makes them the scene's found constraints: one FaceContact for two
  /// bodies if the scene names that kind, else a Contact for each point, with Friction if the scene names it.
  /// Bodies that a constraint joins, and two that do not move, pass through each other.
  template <class S>
  void find(S& scene) {
    if (scene.colliders.shapes.empty()) return;
    note_joined(scene);
    const auto& [shapes, surfaces, margin] = scene.colliders;
    const auto& bodies = scene.bodies;
    bounds_.clear();
    for (std::size_t i = 0; i < shapes.size(); ++i)
      bounds_.push_back(fattened(bounds<M>(shapes[i], bodies.pose[i]), 0.5 * margin));

    found_.clear();
    bool same = true;
    auto known = touches_.begin();
    for (const auto& [i, j] : broad_phase_.overlapping(bounds_)) {
      if (!moves(bodies.inverse_mass[i]) && !moves(bodies.inverse_mass[j])) continue;
      if (std::binary_search(joined_.begin(), joined_.end(), std::pair(i, j))) continue;
      while (known != touches_.end() && std::pair(known->body1, known->body2) < std::pair(i, j)) ++known;
      const bool again = known != touches_.end() && known->body1 == i && known->body2 == j;
      const Manifold<M> manifold = touch<M>(shapes[i], bodies.pose[i], shapes[j], bodies.pose[j], margin,
                                            again ? known->manifold.reference : 0);
      if (manifold.empty()) continue;
      Touch& touch = found_.emplace_back(Touch{i, j, manifold});
      if (again) hand_on(*known, touch);
      same = same && again && known->manifold.size == manifold.size &&
             known - touches_.begin() == static_cast<std::ptrdiff_t>(found_.size()) - 1;
    }
    same = same && found_.size() == touches_.size() && version_ == scene.version();
    if (same)
      for (std::size_t t = 0; t < found_.size(); ++t) rewrite(found_[t], touches_[t].constraint, scene);
    else
      write_anew(scene);
    std::swap(touches_, found_);
    version_ = scene.version();
  }

  /// Gives the found rows of the scene's system the impulses that their contacts had.
  template <class S>
  void write_impulses(System<M>& system) const {
    for (const Touch& touch : touches_)
      for_each_row<S>(touch, system.row_of, [&](int row, double kept) { system.lambda[row] = kept; });
  }
  /// Keeps the impulses of the found rows for the next step.
  template <class S>
  void read_impulses(const System<M>& system) {
    for (Touch& touch : touches_)
      for_each_row<S>(touch, system.row_of, [&](int row, double& kept) { kept = system.lambda[row]; });
  }

 private:
  template <class S>
  void note_joined(const S& scene) {
    if (lasting_ == scene.lasting()) return;
    lasting_ = scene.lasting();
    joined_.clear();
    int number = 0;
    scene.for_each([&](const auto& constraint) {
      if (number++ < lasting_) joined_.push_back(std::minmax({constraint.at.body1, constraint.at.body2}));
    });
    std::sort(joined_.begin(), joined_.end());
  }

  /// λ of points that are the same as before; friction is turned into the new tangents.
  static void hand_on(const Touch& before, Touch& now) {
    const auto turn =
        (tangents_of<M>(now.manifold.normal).transpose() * tangents_of<M>(before.manifold.normal)).eval();
    now.slip[0] = turn * before.slip[0];
    for (int p = 0; p < now.manifold.size; ++p)
      for (int q = 0; q < before.manifold.size; ++q)
        if (now.manifold.points[p].feature == before.manifold.points[q].feature) {
          now.normal[p] = before.normal[q];
          now.slip[p] = turn * before.slip[q];
        }
  }

  template <class S>
  void write_anew(S& scene) {
    scene.forget_found();
    for (Touch& touch : found_) {
      touch.constraint = scene.count();
      if constexpr (makes_faces<S>) {
        scene.add_found(face(touch, scene));
      } else {
        for (int p = 0; p < touch.manifold.size; ++p) {
          const int leader = scene.add_found(contact(touch, p, scene));
          if constexpr (S::template names<Friction>) scene.add_found(friction(touch, p, leader, scene));
        }
      }
    }
  }
  template <class S>
  void rewrite(Touch& touch, int constraint, S& scene) {
    touch.constraint = constraint;
    if constexpr (makes_faces<S>) {
      scene.template at<FaceContact>(constraint) = face(touch, scene);
    } else {
      for (int p = 0; p < touch.manifold.size; ++p) {
        const int leader = constraint;
        scene.template at<Contact>(constraint++) = contact(touch, p, scene);
        if constexpr (S::template names<Friction>)
          scene.template at<Friction>(constraint++) = friction(touch, p, leader, scene);
      }
    }
  }

  /// Calls f(row, impulse) for each row that came of a touch.
  template <class S, class AnyTouch, class F>
  static void for_each_row(AnyTouch& touch, const std::vector<int>& row_of, F&& f) {
    int constraint = touch.constraint;
    if constexpr (makes_faces<S>) {
      const int row = row_of[constraint];
      f(row, touch.normal[0]);
      f(row + 1, touch.normal[1]);
      f(row + 2, touch.slip[0][0]);
    } else {
      for (int p = 0; p < touch.manifold.size; ++p) {
        f(row_of[constraint++], touch.normal[p]);
        if constexpr (S::template names<Friction>) {
          for (int k = 0; k < tangents; ++k) f(row_of[constraint] + k, touch.slip[p][k]);
          ++constraint;
        }
      }
    }
  }

  template <class S>
  static Anchors<M> anchors(const Touch& touch, int p, const S& scene) {
    const auto& point = touch.manifold.points[p];
    return {touch.body1,
            touch.body2,
            {arm_to<M>(scene.bodies.pose[touch.body1], point.p1),
             arm_to<M>(scene.bodies.pose[touch.body2], point.p2)}};
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
    face.at = anchors(touch, 0, scene);
    face.point = touch.manifold.size == 1;
    if (!face.point) face.second = anchors(touch, 1, scene).arms;
    face.normal = touch.manifold.normal;
    face.coefficient = friction_of(touch, scene);
    face.restitution = restitution_of(touch, scene);
    return face;
  }
  template <class S>
  static Contact<M> contact(const Touch& touch, int p, const S& scene) {
    Contact<M> contact{anchors(touch, p, scene), touch.manifold.normal};
    contact.restitution = restitution_of(touch, scene);
    return contact;
  }
  template <class S>
  static Friction<M> friction(const Touch& touch, int p, int leader, const S& scene) {
    return {anchors(touch, p, scene), tangents_of<M>(touch.manifold.normal), friction_of(touch, scene), leader};
  }

  SweepAndPrune<M::linear> broad_phase_;
  std::vector<Bounds<M>> bounds_;
  std::vector<std::pair<int, int>> joined_;
  std::vector<Touch> touches_, found_;
  int lasting_ = -1, version_ = -1;
};

/// What scenes have in its place in which nothing can touch.
struct NoTouching {};

}  // namespace byhand
