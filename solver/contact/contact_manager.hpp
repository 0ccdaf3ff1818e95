#pragma once

#include <array>
#include <cstdint>
#include <utility>
#include <vector>

#include "solver/constraints/anchors.hpp"
#include "solver/contact/manifold.hpp"
#include "solver/contact/sweep_and_prune.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// Finds the contacts of a scene from its shapes, step after step, writes them into the scene as constraints, and
/// keeps their impulses for the warm start of the next step. Particles have no shapes and no contacts.
template <class M>
class ContactManager {
 public:
  /// Looks for contacts at the current poses and makes them the scene's found constraints, as its ContactRows say.
  /// Bodies that a constraint joins, and two fixed ones, pass through each other. Two bodies that have moved less
  /// than a hundredth of the margin since their contact was found keep it: its arms turn with them.
  void find(Scene<M>& scene);
  /// Gives the rows of found contacts the impulses that they had in the last step.
  void write_impulses(const Scene<M>& scene, System<M>& system) const;
  /// Keeps the impulses of found contacts for the next step.
  void read_impulses(const System<M>& system);

 private:
  static constexpr int tangents = M::linear - 1;
  static constexpr int capacity = Manifold<M>::capacity;

  /// The contact of two bodies, body1 < body2: points as arms in the bodies' frames, and their impulses [N s].
  struct Pair {
    int body1, body2;
    int size;                 // of the manifold
    std::uint32_t reference;  // of the manifold
    int constraint;           // the place of the first constraint that was made of it
    bool one_manifold;        // made a single ContactManifold, not a Contact for each point
    double friction, restitution;
    std::array<std::uint32_t, capacity> features;
    Linear<M> normal;
    std::array<Arms<M>, capacity> arms;
    std::array<double, capacity> normal_impulse = {};
    std::array<Eigen::Matrix<double, tangents, 1>, capacity> tangent_impulse =
        {};  // the first alone of a manifold
  };

  bool note_moved(const Scene<M>& scene);
  static double displacement(const Pose<M>& before, const Pose<M>& now, const Bounds<M>& bounds);
  void note_joined(const Scene<M>& scene);
  bool look(const Scene<M>& scene, int body1, int body2, const Pair* before);
  static void keep_impulses(const Pair& before, Pair& now);
  void add_constraints(Scene<M>& scene);
  void rewrite_constraints(const Pair& pair, Scene<M>& scene) const;
  template <class Put>
  static void for_each_constraint(const Pair& pair, Put&& put);
  template <class AnyPair, class F>
  static void for_each_row(AnyPair& pair, const std::vector<int>& row_of, F&& f);

  SweepAndPrune<M::linear> broad_phase_;
  std::vector<Pose<M>> seen_;  // of each body when contacts were last looked for
  std::vector<Bounds<M>> bounds_;
  std::vector<char> moved_;  // by body, since then
  std::vector<std::pair<int, int>> joined_;
  std::vector<Pair> pairs_, found_;
  std::uint64_t version_ = 0;
};

template <int L>
class ContactManager<Model<L, 0>> {
  using M = Model<L, 0>;

 public:
  void find(Scene<M>&) {}
  void write_impulses(const Scene<M>&, System<M>&) const {}
  void read_impulses(const System<M>&) {}
};

}  // namespace byhand
