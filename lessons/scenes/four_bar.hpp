#pragma once

#include "lessons/scenes/pendulum.hpp"
#include "lessons/scenes/rod.hpp"
#include "solver/constraints/pin.hpp"

namespace byhand {

/// Equal arms that hang from the ground and carry a coupler between their lower ends.
struct FourBarOptions {
  double arm = 1, coupler = 2;            // lengths [m]
  double arm_mass = 1, coupler_mass = 1;  // [kg]
  double angle = 0;                       // of the arms from straight down [rad]; π/2 is flat
  int arms = 2;                           // >= 2; a third repeats what two say
};

/// A parallelogram of pinned rods, the first arm's pivot at the origin and the last one's at (coupler, 0): the
/// coupler keeps level, so it swings like a pendulum of length a (⅔ m_a + m_c)/(m_a + m_c) if there are two arms.
/// Body 0 is the ground, body i the i-th arm, the last body the coupler; of the pins two belong to each arm, the
/// upper first.
inline Scene<PlaneBody> four_bar(const FourBarOptions& bars) {
  require(bars.arms >= 2, "number of arms", bars.arms, "at least 2");
  using M = PlaneBody;
  Scene<M> scene;
  const Linear<M> down = bars.arm * from_straight_down<M>(bars.angle), across(bars.coupler, 0);
  const auto upper_end = [&](int arm) { return Linear<M>(static_cast<double>(arm) / (bars.arms - 1) * across); };
  const int ground = scene.add_body(Linear<M>(0, 0), fixed<M>());
  for (int i = 0; i < bars.arms; ++i) {
    const PlaneRod arm(upper_end(i), upper_end(i) + down, bars.arm_mass);
    scene.add_body(arm.pose, arm.mass);
  }
  const PlaneRod rod(down, down + across, bars.coupler_mass);
  const int coupler = scene.add_body(rod.pose, rod.mass);
  for (int i = 0; i < bars.arms; ++i) {
    scene.add(pin<M>(scene.bodies(), ground, 1 + i, upper_end(i)));
    scene.add(pin<M>(scene.bodies(), 1 + i, coupler, Linear<M>(upper_end(i) + down)));
  }
  return scene;
}

/// The length [m] of the simple pendulum that swings like it.
inline double pendulum_length(const FourBarOptions& bars) {
  const double arms = bars.arms * bars.arm_mass;
  return bars.arm * (arms / 3 + bars.coupler_mass) / (arms / 2 + bars.coupler_mass);
}

}  // namespace byhand
