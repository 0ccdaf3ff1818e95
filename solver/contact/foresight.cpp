#include <algorithm>

#include "solver/contact/contact_manager.hpp"
#include "solver/contact/meeting.hpp"
#include "solver/support/each_model.hpp"

// Whether the search for contacts has seen enough. It looks along the motion that it expects, and the impulses
// that come of it give bodies another: a bar that one end stops swings on with the other, a ball that is struck
// flies on.
namespace byhand {

template <class M>
bool ContactManager<M>::foresaw(const Scene<M>& scene, const System<M>& system, double h, double left) {
  const auto& shapes = scene.colliders().shapes;
  if (shapes.empty() || time_ == 0) return true;
  const double thin = 0.5 * thinnest_;
  bool any = false, turning = false;  // any that parts from what was expected; any that turns far
  for (std::size_t i = 0; i < shapes.size(); ++i) {
    const Velocity<M>& velocity = scene.bodies().velocity[i];
    const Velocity<M> change = velocity - velocities_[i];
    const auto* box = std::get_if<Box<M>>(&shapes[i]);
    const double reach2 = box ? box->half().squaredNorm() : 0;  // r²
    const double spin2 = velocity.template tail<M::angular>().squaredNorm();
    turning = turning || h * h * h * h * spin2 * spin2 * reach2 > thinnest_ * thinnest_;
    // (|v| + |ω|r)² <= 2(v² + ω²r²), which needs no root.
    const double most2 = 2 * (change.template head<M::linear>().squaredNorm() +
                              change.template tail<M::angular>().squaredNorm() * reach2);
    moved_[i] = left * left * most2 > thin * thin && left * top_speed<M>(shapes[i], change) > thin;
    if (!moved_[i]) continue;
    velocities_[i] = velocity;
    rim_speeds_[i] = rim_speed<M>(shapes[i], velocity);
    bounds_[i] = fattened(bounds<M>(shapes[i], scene.bodies().pose[i]),
                          scene.colliders().margin + left * top_speed<M>(shapes[i], velocity));
    any = true;
  }
  for (Pair& pair : pairs_) {
    if (!turning) break;
    if (!turns_too_far(scene, pair, h)) continue;
    bool pressed = false;
    for_each_row(pair, system.row_of, [&](int row, double) { pressed = pressed || system.lambda[row] != 0; });
    if (pressed || points_of(scene.bodies(), pair).gap() <= scene.colliders().margin) return false;
  }
  if (!any) return true;
  search(scene, left);
  return std::none_of(found_.begin(), found_.end(), [&](const Pair& pair) { return sinks_in(scene, pair, left); });
}

/// Whether within h [s] a box of the pair leaves the tangent of its turn, by up to ½h²|ω × (ω × r)| along the
/// normal, by more than half of the thinner one's half thickness.
template <class M>
bool ContactManager<M>::turns_too_far(const Scene<M>& scene, const Pair& pair, double h) const {
  const auto [body1, body2] = pair.bodies;
  const auto& shapes = scene.colliders().shapes;
  const double thinner = std::min(half_thickness<M>(shapes[body1]), half_thickness<M>(shapes[body2]));
  for (const int body : {body1, body2}) {
    const Velocity<M>& velocity = scene.bodies().velocity[body];
    const Angular<M> omega = velocity.template tail<M::angular>();
    double across = omega.norm();  // the part of ω at right angles to the normal
    if constexpr (M::angular == 3) across = omega.cross(pair.normal).norm();
    if (h * h * across * rim_speed<M>(shapes[body], velocity) > thinner) return true;
  }
  return false;
}

/// Whether at the present velocities a point of the pair sinks in within `time` [s] by more than half of the
/// thinner one's half thickness.
template <class M>
bool ContactManager<M>::sinks_in(const Scene<M>& scene, const Pair& pair, double time) const {
  const auto [body1, body2] = pair.bodies;
  if (!moved_[body1] && !moved_[body2]) return false;
  const Mover<M> first = mover(scene, body1), second = mover(scene, body2);
  const double most = 0.5 * std::min(half_thickness<M>(first.shape), half_thickness<M>(second.shape));
  const Manifold<M> points = points_of(scene.bodies(), pair);
  return std::any_of(points.begin(), points.end(), [&](const ContactPoint<M>& point) {
    return time * closing_speed(first, second, pair.normal, point) > std::max(0.0, point.separation) + most;
  });
}

#define BYHAND_INSTANTIATE(M)                                                                           \
  template bool ContactManager<M>::foresaw(const Scene<M>&, const System<M>&, double, double);          \
  template bool ContactManager<M>::turns_too_far(const Scene<M>&, const ContactPair<M>&, double) const; \
  template bool ContactManager<M>::sinks_in(const Scene<M>&, const ContactPair<M>&, double) const
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
