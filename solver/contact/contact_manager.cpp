#include "solver/contact/contact_manager.hpp"

#include <algorithm>
#include <cmath>

#include "solver/constraints/contact_manifold.hpp"
#include "solver/contact/meeting.hpp"
#include "solver/integrate/euler.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// An upper bound on how far any point within `bounds` moved with the body [m].
template <class M>
double displacement(const Pose<M>& before, const Pose<M>& now, const Bounds<M>& bounds) {
  const double way = (now.position - before.position).norm();
  double turned = 0;  // twice the sine of half the angle, or a little more
  if constexpr (M::angular == 1)
    turned =
        Eigen::Vector2d(now.rotation.cos - before.rotation.cos, now.rotation.sin - before.rotation.sin).norm();
  else
    turned = 2 * (now.rotation.coeffs() - before.rotation.coeffs()).norm();
  return turned > 0 ? way + 0.5 * bounds.diagonal().norm() * turned : way;  // bounds may be infinite
}

/// A body's velocity after `time` [s] of gravity, if nothing holds it.
template <class M>
Velocity<M> expected_velocity(const Scene<M>& scene, int body, double time) {
  const Bodies<M>& bodies = scene.bodies();
  Velocity<M> velocity = bodies.velocity[body];
  if (moves(bodies.inverse_mass[body]))
    velocity.template head<M::linear>() += time * gravity_on(bodies, body, scene.gravity);
  return velocity;
}

/// Calls put(constraint) for each constraint made from a pair; it returns the constraint's place among contacts.
template <class M>
void for_each_made_of(const ContactPair<M>& pair, auto&& put) {
  const auto& [first, second] = pair.bodies;
  if constexpr (std::is_same_v<M, PlaneBody>)
    if (pair.one_manifold)
      return void(put(ContactManifold<M>{.at = {first, second, pair.points[0].arms},
                                         .second = pair.points[1].arms,
                                         .point = pair.size == 1,
                                         .normal = pair.normal,
                                         .coefficient = pair.friction,
                                         .restitution = pair.restitution}));
  for (int p = 0; p < pair.size; ++p) {
    const Anchors<M> at{first, second, pair.points[p].arms};
    const int place = put(Contact<M>{.at = at, .normal = pair.normal, .restitution = pair.restitution});
    if (pair.friction > 0) put(Friction<M>{at, tangents_of<M>(pair.normal), pair.friction, place});
  }
}

}  // namespace

template <class M>
bool is_of(const Scene<M>& scene, const ContactPair<M>& pair) {
  const Colliders<M>& colliders = scene.colliders();
  const auto has = [&](int body, std::uint64_t stamp) {
    return scene.bodies().has(body) && body < std::ssize(colliders.shapes) && colliders.stamps[body] == stamp &&
           !std::holds_alternative<std::monostate>(colliders.shapes[body]);
  };
  return has(pair.bodies.first, pair.stamps[0]) && has(pair.bodies.second, pair.stamps[1]);
}

template <class M>
Manifold<M> points_of(const Bodies<M>& bodies, const ContactPair<M>& pair) {
  const auto& [body1, body2] = pair.bodies;
  const Pose<M>&pose1 = bodies.pose[body1], &pose2 = bodies.pose[body2];
  Manifold<M> manifold;
  manifold.normal = pair.normal;
  for (int p = 0; p < pair.size; ++p) {
    const auto& [feature, arms, normal_impulse, tangent_impulse] = pair.points[p];
    const Linear<M> P1 = anchor<M, double>(pose1, in_world<M, double>(pose1, arms.first)),
                    P2 = anchor<M, double>(pose2, in_world<M, double>(pose2, arms.second));
    manifold.add({P1, P2, pair.normal.dot(P2 - P1), feature});
  }
  return manifold;
}

template <class M>
bool ContactManager<M>::find(const Scene<M>& scene, double step) {
  if (scene.colliders().shapes.empty()) {
    const bool had_any = !pairs_.empty();
    pairs_.clear(), constraints_.clear(), version_ = 0;
    return had_any;
  }
  const bool unchanged = version_ == scene.version();
  if (!unchanged) {
    joined_.clear();
    for (const auto& entry : scene.entries()) joined_.push_back(std::minmax(entry.body1, entry.body2));
    std::sort(joined_.begin(), joined_.end());
    thinnest_ = std::numeric_limits<double>::infinity();
    for (const Shape<M>& shape : scene.colliders().shapes)
      thinnest_ = std::min(thinnest_, half_thickness<M>(shape));
  }
  time_ = scene.colliders().lookahead * step;
  if (!update_bounds(scene, unchanged) && unchanged) return false;
  search(scene, time_);
  std::swap(pairs_, found_);
  const auto alike = [](const Pair& a, const Pair& b) { return a.bodies == b.bodies && a.size == b.size; };
  const bool same = unchanged && std::equal(pairs_.begin(), pairs_.end(), found_.begin(), found_.end(), alike);
  write_constraints(same, scene.count());
  version_ = scene.version();
  return !same;
}

template <class M>
void ContactManager<M>::follow_balls(const Scene<M>& scene, System<M>& system) {
  for (Pair& pair : pairs_) {
    if (!pair.round) continue;
    for_each_row(pair, system.row_of, [&](int row, double& kept) { kept = system.lambda[row]; });
    for (const int body : {pair.bodies.first, pair.bodies.second}) expect_motion(scene, body);
    found_.clear();
    collide(scene, pair.bodies, scene.colliders().margin, time_, &pair);
    if (found_.empty()) collide(scene, pair.bodies, std::numeric_limits<double>::infinity(), 0, &pair);
    if (found_.empty()) continue;  // a pose is no number: the step's end says so
    pair = found_.front();
    overwrite_constraints(pair, scene.count());
    for_each_row(pair, system.row_of, [&](int row, double kept) { system.lambda[row] = kept; });
  }
}

template <class M>
void ContactManager<M>::write_impulses(System<M>& system) const {
  for (const Pair& pair : pairs_)
    for_each_row(pair, system.row_of, [&](int row, double kept) { system.lambda[row] = kept; });
}

template <class M>
void ContactManager<M>::read_impulses(const System<M>& system) {
  for (Pair& pair : pairs_)
    for_each_row(pair, system.row_of, [&](int row, double& kept) { kept = system.lambda[row]; });
  const auto before = static_cast<std::ptrdiff_t>(pressed_.size());
  for (const Pair& pair : pairs_)
    if (pair.presses()) pressed_.push_back(pair.bodies);
  if (before == 0) return;
  // Of an earlier part of the step those count too that are still near.
  std::inplace_merge(pressed_.begin(), pressed_.begin() + before, pressed_.end());
  pressed_.erase(std::unique(pressed_.begin(), pressed_.end()), pressed_.end());
  std::erase_if(pressed_, [&](const BodyPair& bodies) {
    return !std::ranges::binary_search(pairs_, bodies, {}, &Pair::bodies);
  });
}

template <class M>
void ContactManager<M>::begin_step(const Scene<M>& scene) {
  pressed_before_.clear();
  for (const Pair& pair : pairs_)
    if (std::ranges::binary_search(pressed_, pair.bodies) && is_of(scene, pair))
      pressed_before_.push_back(pair.bodies);
  pressed_.clear();
}

template <class M>
void ContactManager<M>::expect_motion(const Scene<M>& scene, int body) {
  velocities_[body] = expected_velocity(scene, body, time_);
  rim_speeds_[body] = rim_speed<M>(scene.colliders().shapes[body], velocities_[body]);
}

template <class M>
Mover<M> ContactManager<M>::mover(const Scene<M>& scene, int body) const {
  return {scene.colliders().shapes[body], scene.bodies().pose[body], velocities_[body], rim_speeds_[body]};
}

/// Updates the expected motion of all bodies, and pose and bounds of all or, in an unchanged scene, of those that
/// have moved noticeably or will, within the time that it looks ahead, by noticeably more than before. Returns
/// whether there are any.
template <class M>
bool ContactManager<M>::update_bounds(const Scene<M>& scene, bool unchanged) {
  const auto& shapes = scene.colliders().shapes;
  const double margin = scene.colliders().margin, noticeable = 0.01 * margin;
  poses_.resize(shapes.size());
  bounds_.resize(shapes.size());
  velocities_.resize(shapes.size());
  rim_speeds_.resize(shapes.size());
  way_.resize(shapes.size());
  moved_.assign(shapes.size(), 0);
  bool any = false;
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Pose<M>& pose = scene.bodies().pose[i];
    expect_motion(scene, i);
    const double way = time_ * (velocities_[i].template head<M::linear>().norm() + rim_speeds_[i]);
    const double more = std::max(0.0, way - way_[i]);
    if (unchanged && displacement<M>(poses_[i], pose, bounds_[i]) + more < noticeable) continue;
    poses_[i] = pose;
    way_[i] = way;
    bounds_[i] = fattened(bounds<M>(shapes[i], pose), 0.5 * margin + noticeable + way);
    moved_[i] = any = true;
  }
  return any;
}

/// Finds the contacts of `time` [s] within the bounds: those of bodies that have moved anew.
template <class M>
void ContactManager<M>::search(const Scene<M>& scene, double time) {
  const auto& masses = scene.bodies().inverse_mass;
  const Colliders<M>& colliders = scene.colliders();
  found_.clear();
  auto before = pairs_.begin();
  for (const BodyPair& bodies : broad_phase_.overlapping(bounds_)) {
    const auto& [i, j] = bodies;
    if ((!moves(masses[i]) && !moves(masses[j])) || !meet(colliders.layers[i], colliders.layers[j])) continue;
    if (std::binary_search(joined_.begin(), joined_.end(), bodies)) continue;
    while (before != pairs_.end() && before->bodies < bodies) ++before;
    const bool cached = before != pairs_.end() && before->bodies == bodies &&
                        before->stamps == std::array{colliders.stamps[i], colliders.stamps[j]};
    if (cached && !moved_[i] && !moved_[j])
      found_.push_back(*before);
    else
      collide(scene, bodies, colliders.margin, time, cached ? &*before : nullptr);
  }
  inner_edges_.drop(scene, found_);
}

/// Adds the contact of two bodies to `found_`: the points that would be nearer than `margin` [m] after a `time`
/// [s] of approaching as now. Points that were there `before` keep their impulses, those of friction turned into
/// the new tangents.
template <class M>
void ContactManager<M>::collide(const Scene<M>& scene, const BodyPair& bodies, double margin, double time,
                                const Pair* before) {
  ++computed_;
  const Colliders<M>& colliders = scene.colliders();
  const auto [body1, body2] = bodies;
  const Mover<M> first = mover(scene, body1), second = mover(scene, body2);
  const double way = time * approach(first, second);
  Manifold<M> manifold = byhand::collide<M>(first.shape, first.pose, second.shape, second.pose, margin + way,
                                            before ? before->reference : 0);
  const auto is_near = [&](const ContactPoint<M>& point) { return point.separation <= margin; };
  // What is slow and near stays so, and with the plane that it has.
  if (way > 2 * margin || std::none_of(manifold.begin(), manifold.end(), is_near))
    move_to_meeting(first, second, time, margin, manifold);
  const auto comes_near = [&](const ContactPoint<M>& point) {
    return is_near(point) ||
           point.separation <= margin + time * closing_speed(first, second, manifold.normal, point);
  };
  if (std::none_of(manifold.begin(), manifold.end(), comes_near)) return;
  Pair& pair = found_.emplace_back();
  pair.bodies = bodies;
  pair.stamps = {colliders.stamps[body1], colliders.stamps[body2]};
  pair.size = 0;
  pair.reference = manifold.reference;
  pair.one_manifold = colliders.rows == ContactRows::manifold;
  pair.round = std::holds_alternative<Ball<M>>(first.shape) || std::holds_alternative<Ball<M>>(second.shape);
  pair.friction = std::sqrt(colliders.surfaces[body1].friction * colliders.surfaces[body2].friction);
  pair.restitution = std::max(colliders.surfaces[body1].restitution, colliders.surfaces[body2].restitution);
  pair.normal = manifold.normal;
  for (const ContactPoint<M>& point : manifold)
    if (comes_near(point))
      pair.points[pair.size++] = {point.feature,
                                  {arm_to<M>(first.pose, point.p1), arm_to<M>(second.pose, point.p2)}};
  if (!before) return;
  pair.constraint = before->constraint;
  const Eigen::Matrix<double, Pair::tangents, Pair::tangents> turn =
      tangents_of<M>(pair.normal).transpose().lazyProduct(tangents_of<M>(before->normal));
  for (int p = 0; p < pair.size; ++p)
    for (int q = 0; q < before->size; ++q) {
      const auto& old = before->points[q];
      if (pair.points[p].feature != old.feature) continue;
      pair.points[p].normal_impulse = old.normal_impulse;
      if (pair.one_manifold)
        pair.points[0].tangent_impulse = turn.lazyProduct(before->points[0].tangent_impulse);
      else
        pair.points[p].tangent_impulse = turn.lazyProduct(old.tangent_impulse);
    }
}

/// Overwrites the constraints that were made from a pair; those of the scene stand `before` them.
template <class M>
void ContactManager<M>::overwrite_constraints(const Pair& pair, int before) {
  int place = pair.constraint - before;
  for_each_made_of(pair, [&](const auto& constraint) {
    constraints_.replace(constraints_.entries()[place], constraint);
    return place++;
  });
}

/// Makes the constraints anew or, if they are the `same` in number and kind, overwrites those of bodies that have
/// moved. Those of the scene stand `before` them.
template <class M>
void ContactManager<M>::write_constraints(bool same, int before) {
  if (!same) constraints_.clear();
  for (Pair& pair : pairs_) {
    if (!same) {
      pair.constraint = before + constraints_.count();
      for_each_made_of(pair, [&](const auto& constraint) {
        const int place = constraints_.count();
        constraints_.add(constraint, place);
        return place;
      });
    } else if (moved_[pair.bodies.first] || moved_[pair.bodies.second]) {
      overwrite_constraints(pair, before);
    }
  }
}

#define BYHAND_INSTANTIATE(M)                                  \
  template class ContactManager<M>;                            \
  template bool is_of(const Scene<M>&, const ContactPair<M>&); \
  template Manifold<M> points_of(const Bodies<M>&, const ContactPair<M>&)
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
