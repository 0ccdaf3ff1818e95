#pragma once

#include <algorithm>
#include <array>
#include <cstdint>
#include <vector>

#include "solver/constraints/anchors.hpp"
#include "solver/contact/inner_edges.hpp"
#include "solver/contact/manifold.hpp"
#include "solver/contact/sweep_and_prune.hpp"
#include "solver/scene.hpp"

namespace byhand {

template <class M>
struct Mover;

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
  int constraint;                       // place of the first constraint made from it, after those of the scene
  bool one_manifold;                    // one ContactManifold instead of a Contact for each point
  bool round;                           // whether one of them is a ball
  double friction, restitution;
  Linear<M> normal;
  std::array<Point, Manifold<M>::capacity> points;

  bool presses() const {
    return std::any_of(points.begin(), points.begin() + size, [](const Point& p) { return p.normal_impulse > 0; });
  }
};

/// Calls f(row, impulse) for each row made from a pair.
void for_each_row(auto& pair, const std::vector<int>& row_of, auto&& f) {
  int place = pair.constraint;
  if (pair.one_manifold) {
    for (int p = 0; p < 2; ++p) f(row_of[place] + p, pair.points[p].normal_impulse);
    return f(row_of[place] + 2, pair.points[0].tangent_impulse[0]);
  }
  for (int p = 0; p < pair.size; ++p) {
    f(row_of[place++], pair.points[p].normal_impulse);
    if (pair.friction == 0) continue;
    int row = row_of[place++];
    for (auto& impulse : pair.points[p].tangent_impulse) f(row++, impulse);
  }
}

/// Whether the scene still has both bodies with the shapes that met.
template <class M>
bool is_of(const Scene<M>& scene, const ContactPair<M>& pair);

/// Where the points of a pair are at the bodies' present poses.
template <class M>
Manifold<M> points_of(const Bodies<M>& bodies, const ContactPair<M>& pair);

/// Finds a scene's contacts from its shapes, and keeps the constraints made from them, whose rows follow those of
/// the scene, and their impulses for the warm start of the next step. Particles have no shapes and no contacts.
template <class M>
class ContactManager {
 public:
  /// Finds what may touch within `step` [s] >= 0 and makes constraints of it, as the scene's ContactRows say.
  /// Returns whether these are others than before, so that rows have to be laid out anew. Bodies joined by a
  /// constraint do not collide, nor do fixed ones with each other. What lies ahead counts only if the shapes,
  /// moved on as fast as now, will meet, and with the normal that they will meet with. A contact is computed again
  /// only if one of its bodies has moved by more than a hundredth of the margin; until then its arms turn with the
  /// bodies.
  bool find(const Scene<M>& scene, double step = 0);
  /// Moves the contact points of balls to where these touch, or will meet, from the current poses on: the arm of a
  /// ball that rolls would leave with its material. λ of their friction, in `system`, turns with the tangents.
  void follow_balls(const Scene<M>& scene, System<M>& system);
  /// Sets λ of the contacts to their impulses of the last step.
  void write_impulses(System<M>& system) const;
  /// Keeps λ of the contacts for the next step, or its next part.
  void read_impulses(const System<M>& system);
  /// Whether the contacts are still the right ones at the velocities that their rows have left: for `left` [s]
  /// until the next call of `find` nothing sinks in, and in a substep h [s] no box that is pressed leaves the
  /// tangent of its turn, by more than half of the thinner body's half thickness. It looks again only for bodies
  /// that part from the motion that `find` expected, and not without a lookahead.
  bool foresaw(const Scene<M>& scene, const System<M>& system, double h, double left);
  /// Begins a step. Those that pressed in the last one become those of the step before, if they are still there.
  void begin_step(const Scene<M>& scene);

  /// The constraints that were made of the pairs; the friction of a Contact names its place.
  const ConstraintList<M>& constraints() const { return constraints_; }
  /// In ascending order of bodies, as are those that pressed in the last step and in the step before.
  const std::vector<ContactPair<M>>& pairs() const { return pairs_; }
  const std::vector<BodyPair>& pressed() const { return pressed_; }
  const std::vector<BodyPair>& pressed_before() const { return pressed_before_; }
  long long computed() const { return computed_; }  // contacts of pairs, in all

 private:
  using Pair = ContactPair<M>;

  void expect_motion(const Scene<M>& scene, int body);
  bool update_bounds(const Scene<M>& scene, bool unchanged);
  void search(const Scene<M>& scene, double time);
  Mover<M> mover(const Scene<M>& scene, int body) const;
  bool turns_too_far(const Scene<M>& scene, const Pair& pair, double h) const;
  bool sinks_in(const Scene<M>& scene, const Pair& pair, double time) const;
  void collide(const Scene<M>& scene, const BodyPair& bodies, double margin, double time, const Pair* before);
  void write_constraints(bool same, int before);
  void overwrite_constraints(const Pair& pair, int before);

  SweepAndPrune<M::linear> broad_phase_;
  InnerEdges<M> inner_edges_;
  std::vector<Velocity<M>> velocities_;   // by body, expected within the time that is looked ahead
  std::vector<double> rim_speeds_, way_;  // of these; added to the bounds for each body's motion [m]
  std::vector<Pose<M>> poses_;            // by body, at which its contacts were computed
  std::vector<Bounds<M>> bounds_;         // at those poses, with a margin
  std::vector<char> moved_;               // by body, whether its contacts are to be computed again
  std::vector<BodyPair> joined_;          // by constraints; sorted
  std::vector<Pair> pairs_, found_;
  ConstraintList<M> constraints_;
  std::vector<BodyPair> pressed_, pressed_before_;
  double thinnest_ = 0, time_ = 0;  // the least half thickness [m]; that the last call of `find` looked ahead [s]
  std::uint64_t version_ = 0;       // of the scene whose contacts these are
  long long computed_ = 0;
};

template <int L>
class ContactManager<Model<L, 0>> {
  using M = Model<L, 0>;

 public:
  bool find(const Scene<M>&, double = 0) { return false; }
  void follow_balls(const Scene<M>&, System<M>&) {}
  void write_impulses(System<M>&) const {}
  void read_impulses(const System<M>&) {}
  bool foresaw(const Scene<M>&, const System<M>&, double, double) { return true; }
  void begin_step(const Scene<M>&) {}
  const ConstraintList<M>& constraints() const { return none_; }

 private:
  ConstraintList<M> none_;
};

/// Calls f(store, entry) for each constraint of a scene in natural order, and then for each contact of bodies that
/// it still has.
template <class M, class F>
void for_each_constraint(const Scene<M>& scene, const ContactManager<M>& contacts, F&& f) {
  for (const ConstraintList<M>* list : {&scene.constraints(), &contacts.constraints()})
    for (const auto& entry : list->entries())
      if (scene.bodies().has(entry.body1) && scene.bodies().has(entry.body2)) f(list->store(entry.kind), entry);
}

}  // namespace byhand
