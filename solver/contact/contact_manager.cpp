#include "solver/contact/contact_manager.hpp"

#include <algorithm>
#include <cmath>

#include "solver/constraints/contact_manifold.hpp"

namespace byhand {
namespace {

ContactManifold<PlaneBody> manifold_of(const auto& pair) {
  ContactManifold<PlaneBody> manifold;
  manifold.at = {pair.body1, pair.body2, pair.arms[0]};
  manifold.point = pair.size == 1;
  manifold.second = pair.arms[1];
  manifold.normal = pair.normal;
  manifold.coefficient = pair.friction;
  manifold.restitution = pair.restitution;
  return manifold;
}

}  // namespace

template <class M>
void ContactManager<M>::find(Scene<M>& scene) {
  if (scene.colliders().shapes.empty()) return pairs_.clear();
  const bool unchanged = version_ == scene.version();
  if (!unchanged) seen_.clear();
  if (!note_moved(scene) && unchanged) return;
  if (!unchanged) note_joined(scene);
  const Bodies<M>& bodies = scene.bodies();
  found_.clear();
  bool same = unchanged;
  auto known = pairs_.begin();
  for (const auto& [i, j] : broad_phase_.overlapping(bounds_)) {
    if (!moves(bodies.inverse_mass[i]) && !moves(bodies.inverse_mass[j])) continue;
    if (std::binary_search(joined_.begin(), joined_.end(), std::pair(i, j))) continue;
    while (known != pairs_.end() && std::pair(known->body1, known->body2) < std::pair(i, j)) ++known;
    const bool again = known != pairs_.end() && known->body1 == i && known->body2 == j;
    if (again && !moved_[i] && !moved_[j])
      found_.push_back(*known);
    else if (!look(scene, i, j, again ? &*known : nullptr))
      continue;
    same = same && again && known->size == found_.back().size &&
           known - pairs_.begin() == static_cast<std::ptrdiff_t>(found_.size()) - 1;
  }
  std::swap(pairs_, found_);
  if (same && pairs_.size() == found_.size())
    for (const Pair& pair : pairs_) rewrite_constraints(pair, scene);
  else
    add_constraints(scene);
  version_ = scene.version();
}

template <class M>
void ContactManager<M>::write_impulses(const Scene<M>&, System<M>& system) const {
  for (const Pair& pair : pairs_)
    for_each_row(pair, system.row_of, [&](int row, double kept) { system.lambda[row] = kept; });
}

template <class M>
void ContactManager<M>::read_impulses(const System<M>& system) {
  for (Pair& pair : pairs_)
    for_each_row(pair, system.row_of, [&](int row, double& kept) { kept = system.lambda[row]; });
}

/// Notes which bodies have moved noticeably since they were last looked at, and where those are now. Returns
/// whether there are any.
template <class M>
bool ContactManager<M>::note_moved(const Scene<M>& scene) {
  const auto& shapes = scene.colliders().shapes;
  const double margin = scene.colliders().margin, noticeable = 0.01 * margin;
  const auto known = seen_.size();
  seen_.resize(shapes.size());
  bounds_.resize(shapes.size());
  moved_.assign(shapes.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Pose<M>& pose = scene.bodies().pose[i];
    if (i < known &&
        (!moves(scene.bodies().inverse_mass[i]) || displacement(seen_[i], pose, bounds_[i]) < noticeable))
      continue;
    seen_[i] = pose;
    bounds_[i] = fattened(bounds<M>(shapes[i], pose), 0.5 * margin + noticeable);
    moved_[i] = 1;
    any = true;
  }
  return any;
}

/// How far a body's points have moved at most [m], by its position and by turning what its bounds can hold.
template <class M>
double ContactManager<M>::displacement(const Pose<M>& before, const Pose<M>& now, const Bounds<M>& bounds) {
  double turned = 0;  // twice the sine of half the angle, or a little more
  if constexpr (M::angular == 1)
    turned =
        Eigen::Vector2d(now.rotation.cos - before.rotation.cos, now.rotation.sin - before.rotation.sin).norm();
  else
    turned = 2 * (now.rotation.coeffs() - before.rotation.coeffs()).norm();
  return (now.position - before.position).norm() + 0.5 * bounds.diagonal().norm() * turned;
}

template <class M>
void ContactManager<M>::note_joined(const Scene<M>& scene) {
  joined_.clear();
  for (int place = 0; place < scene.lasting(); ++place)
    joined_.push_back(std::minmax(scene.entries()[place].body1, scene.entries()[place].body2));
  std::sort(joined_.begin(), joined_.end());
}

/// Finds the contact of two bodies; returns whether they touch.
template <class M>
bool ContactManager<M>::look(const Scene<M>& scene, int body1, int body2, const Pair* before) {
  const auto& [shapes, surfaces, margin, rows] = scene.colliders();
  const Pose<M>&pose1 = scene.bodies().pose[body1], &pose2 = scene.bodies().pose[body2];
  const Manifold<M> manifold =
      touch<M>(shapes[body1], pose1, shapes[body2], pose2, margin, before ? before->reference : 0);
  if (manifold.empty()) return false;
  Pair& now = found_.emplace_back();
  now.body1 = body1;
  now.body2 = body2;
  now.size = manifold.size;
  now.reference = manifold.reference;
  now.one_manifold = rows == ContactRows::manifold;
  now.friction = std::sqrt(surfaces[body1].friction * surfaces[body2].friction);
  now.restitution = std::max(surfaces[body1].restitution, surfaces[body2].restitution);
  now.normal = manifold.normal;
  for (int p = 0; p < manifold.size; ++p) {
    now.features[p] = manifold.points[p].feature;
    now.arms[p] = {arm_to<M>(pose1, manifold.points[p].p1), arm_to<M>(pose2, manifold.points[p].p2)};
  }
  if (before) keep_impulses(*before, now);
  return true;
}

/// λ of points that are the same as before; friction is turned into the new tangents.
template <class M>
void ContactManager<M>::keep_impulses(const Pair& before, Pair& now) {
  now.constraint = before.constraint;
  const Eigen::Matrix<double, tangents, tangents> turn =
      tangents_of<M>(now.normal).transpose().lazyProduct(tangents_of<M>(before.normal));
  now.tangent_impulse[0] = turn.lazyProduct(before.tangent_impulse[0]);
  for (int p = 0; p < now.size; ++p)
    for (int q = 0; q < before.size; ++q)
      if (now.features[p] == before.features[q]) {
        now.normal_impulse[p] = before.normal_impulse[q];
        now.tangent_impulse[p] = turn.lazyProduct(before.tangent_impulse[q]);
      }
}

template <class M>
void ContactManager<M>::add_constraints(Scene<M>& scene) {
  scene.forget_found();
  for (Pair& pair : pairs_) {
    pair.constraint = scene.count();
    for_each_constraint(pair, [&](const auto& constraint) { return scene.add_found(constraint); });
  }
  if (!pairs_.empty()) scene.changed();
}

template <class M>
void ContactManager<M>::rewrite_constraints(const Pair& pair, Scene<M>& scene) const {
  if (!moved_[pair.body1] && !moved_[pair.body2]) return;
  int place = pair.constraint;
  for_each_constraint(pair, [&]<class Kind>(const Kind& constraint) {
    const auto& entry = scene.entries()[place];
    scene.template constraints<Kind>(entry.kind).all[entry.index] = constraint;
    return -1 - place++;
  });
}

/// Calls put(constraint) for each constraint that is made of a pair; it returns the identity that this one has.
template <class M>
template <class Put>
void ContactManager<M>::for_each_constraint(const Pair& pair, Put&& put) {
  if constexpr (std::is_same_v<M, PlaneBody>)
    if (pair.one_manifold) return void(put(manifold_of(pair)));
  for (int p = 0; p < pair.size; ++p) {
    const Anchors<M> at{pair.body1, pair.body2, pair.arms[p]};
    Contact<M> contact{at, pair.normal};
    contact.restitution = pair.restitution;
    const int id = put(contact);
    if (pair.friction > 0) put(Friction<M>{at, tangents_of<M>(pair.normal), pair.friction, id});
  }
}

/// Calls f(row, impulse) for each row that was made of a pair.
template <class M>
template <class AnyPair, class F>
void ContactManager<M>::for_each_row(AnyPair& pair, const std::vector<int>& row_of, F&& f) {
  int constraint = pair.constraint;
  if (pair.one_manifold) {
    const int row = row_of[constraint];
    f(row, pair.normal_impulse[0]);
    f(row + 1, pair.normal_impulse[1]);
    f(row + 2, pair.tangent_impulse[0][0]);
    return;
  }
  for (int p = 0; p < pair.size; ++p) {
    f(row_of[constraint++], pair.normal_impulse[p]);
    if (pair.friction == 0) continue;
    for (int k = 0; k < tangents; ++k) f(row_of[constraint] + k, pair.tangent_impulse[p][k]);
    ++constraint;
  }
}

template class ContactManager<PlaneBody>;
template class ContactManager<SpaceBody>;

}  // namespace byhand
