#include "solver/contact/meeting.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

/// Nearer than this share of the margin, shapes touch, and their normal is what it will be.
constexpr double touching = 0.05;
constexpr int most_advances = 32;

/// ω × r: what turning adds to the velocity of a mover's point that is `arm` [m] from its centre [m/s].
template <class M>
Linear<M> turning_of(const Mover<M>& mover, const Linear<M>& arm) {
  if constexpr (M::angular == 1)
    return mover.angular()[0] * Linear<M>(-arm.y(), arm.x());
  else
    return mover.angular().cross(arm);
}

/// Nothing passes by a plane but a box whose corners' circle stays above it while their tangents do not.
template <class M>
void leave_out_above(const Linear<M>& up, const Linear<M>& on_plane, const Mover<M>& plane, const Mover<M>& mover,
                     double time, double margin, Manifold<M>& manifold) {
  const auto* box = std::get_if<Box<M>>(&mover.shape);
  if (!box) return;
  const double height = up.dot(mover.pose.position - on_plane), rate = up.dot(mover.linear() - plane.linear());
  if (height + std::min(0.0, time * rate) > box->half().norm() + margin) manifold.size = 0;
}

}  // namespace

template <class M>
double closing_speed(const Mover<M>& first, const Mover<M>& second, const Linear<M>& normal,
                     const ContactPoint<M>& point) {
  return normal.dot(first.linear() - second.linear() + turning_of<M>(first, point.p1 - first.pose.position) -
                    turning_of<M>(second, point.p2 - second.pose.position));
}

template <class M>
void move_to_meeting(const Mover<M>& first, const Mover<M>& second, double time, double margin,
                     Manifold<M>& manifold) {
  const double way = time * approach(first, second);
  if (manifold.empty()) return;
  if (std::holds_alternative<HalfSpace<M>>(first.shape))
    return leave_out_above<M>(manifold.normal, manifold.points[0].p1, first, second, time, margin, manifold);
  if (std::holds_alternative<HalfSpace<M>>(second.shape))
    return leave_out_above<M>(-manifold.normal, manifold.points[0].p2, second, first, time, margin, manifold);
  if (const double now = manifold.gap(); now <= touching * margin || now >= way) return;
  const double turning = first.rim_speed + second.rim_speed;
  double passed = 0;
  Pose<M> pose1 = first.pose, pose2 = second.pose;
  for (int advance = 0; advance < most_advances; ++advance) {
    const double left = manifold.gap();
    const double speed = turning + manifold.normal.dot(first.linear() - second.linear());
    if (left <= touching * margin) break;
    if (speed <= 0 || passed == time) {
      if (left > margin) manifold.size = 0;
      break;
    }
    passed = std::min(time, passed + left / speed);
    pose1 = moved<M>(first.pose, first.velocity, passed);
    pose2 = moved<M>(second.pose, second.velocity, passed);
    manifold = collide<M>(first.shape, pose1, second.shape, pose2, margin + way, manifold.reference);
    if (manifold.empty()) return;
  }
  const auto moved_back = [&](const Linear<M>& point, const Mover<M>& mover, const Pose<M>& pose) -> Linear<M> {
    const double rate = manifold.normal.dot(turning_of<M>(mover, point - pose.position));
    return point - passed * (mover.linear() + rate * manifold.normal);
  };
  for (int p = 0; p < manifold.size; ++p) {
    ContactPoint<M>& point = manifold.points[p];
    point.p1 = moved_back(point.p1, first, pose1);
    point.p2 = moved_back(point.p2, second, pose2);
    point.separation = manifold.normal.dot(point.p2 - point.p1);
  }
}

#define BYHAND_INSTANTIATE(M)                                                                                   \
  template double closing_speed<M>(const Mover<M>&, const Mover<M>&, const Linear<M>&, const ContactPoint<M>&); \
  template void move_to_meeting<M>(const Mover<M>&, const Mover<M>&, double, double, Manifold<M>&)
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
