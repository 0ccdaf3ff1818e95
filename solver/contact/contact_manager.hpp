#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "solver/constraints/anchors.hpp"
#include "solver/contact/manifold.hpp"
#include "solver/contact/sweep_and_prune.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// The contact of two bodies, and its impulses in the last step [N s].
template <class M>
struct ContactPair {
  static constexpr int tangents = M::linear - 1;
  struct Point {
    std::uint32_t feature;
    Arms<M> arms;
    double normal_impulse = 0;
    Rows<tangents> tangent_impulse = Rows<tangents>::Zero();  // of a ContactManifold only the first point's
  };

  BodyPair bodies;
  std::array<std::uint64_t, 2> stamps;  // of both, as in Colliders
  int size;                             // of the manifold
  std::uint32_t reference;              // of the manifold
  int constraint;                       // place of the first constraint made from it
  bool one_manifold;                    // one ContactManifold instead of a Contact for each point
  bool round;                           // whether one of them is a ball
  double friction, restitution;
  Linear<M> normal;
  std::array<Point, Manifold<M>::capacity> points;

  bool presses() const {
    return std::any_of(points.begin(), points.begin() + size, [](const Point& p) { return p.normal_impulse > 0; });
  }
};

/// Finds a scene's contacts from its shapes, adds them to the scene as constraints, and keeps their impulses for
/// the warm start of the next step. Particles have no shapes and no contacts.
template <class M>
class ContactManager {
 public:
  /// Finds what may touch within `step` [s] >= 0 and makes it the scene's found constraints, as its ContactRows
  /// say. Bodies joined by a constraint do not collide, nor do fixed ones with each other. A contact is computed
  /// again only if one of its bodies has moved by more than a hundredth of the margin; until then its arms turn
  /// with the bodies.
  void find(Scene<M>& scene, double step = 0);
  /// Moves the contact points of balls to where these touch at the current poses: the arm of a ball that rolls
  /// would leave with its material. λ of their friction, in `system`, turns with the tangents.
  void follow_balls(Scene<M>& scene, System<M>& system);
  /// Sets λ of found contacts to their impulses of the last step.
  void write_impulses(System<M>& system) const;
  /// Keeps λ of found contacts for the next step.
  void read_impulses(const System<M>& system);

  /// In ascending order of bodies, as are those that pressed in the last step and in the step before.
  const std::vector<ContactPair<M>>& pairs() const { return pairs_; }
  const std::vector<BodyPair>& pressed() const { return pressed_; }
  const std::vector<BodyPair>& pressed_before() const { return pressed_before_; }

 private:
  using Pair = ContactPair<M>;

  bool update_bounds(const Scene<M>& scene, bool unchanged, double time);
  void collide(const Scene<M>& scene, const BodyPair& bodies, double margin, double time, const Pair* before);
  void write_constraints(bool same, Scene<M>& scene);
  void overwrite_constraints(const Pair& pair, Scene<M>& scene);

  SweepAndPrune<M::linear> broad_phase_;
  std::vector<Pose<M>> poses_;     // by body, at which its contacts were computed
  std::vector<Bounds<M>> bounds_;  // at those poses, with a margin
  std::vector<double> way_;        // that was added to them for each body's motion [m]
  std::vector<char> moved_;        // by body, whether its contacts are to be computed again
  std::vector<BodyPair> joined_;   // by constraints; sorted
  std::vector<Pair> pairs_, found_;
  std::vector<BodyPair> pressed_, pressed_before_;
  std::uint64_t version_ = 0, written_ = 0;  // of the scene
};

template <int L>
class ContactManager<Model<L, 0>> {
 public:
  void find(Scene<Model<L, 0>>&, double = 0) {}
  void follow_balls(Scene<Model<L, 0>>&, System<Model<L, 0>>&) {}
  void write_impulses(System<Model<L, 0>>&) const {}
  void read_impulses(const System<Model<L, 0>>&) {}
};

}  // namespace byhand
