#pragma once

#include <Eigen/Core>

namespace byhand {

/// Two bobs on massless rods, the second hung from the first, in the plane: integrated in its two angles from
/// straight down, so that no constraint is there to drift. Beyond a few seconds it is chaos; the uncertainty
/// tells.
class DoublePendulum {
 public:
  struct State {
    Eigen::Vector2d angles;              // from straight down [rad]
    Eigen::Vector2d angular_velocities;  // [rad/s]
    double uncertainty = 0;              // largest error expected in any of the four numbers
  };

  /// `start` at time 0, `lengths` [m] and `masses` [kg] from the top down, `gravity` [m/s²].
  /// Throws std::invalid_argument unless the start is finite and the others positive.
  DoublePendulum(const State& start, const Eigen::Vector2d& lengths, const Eigen::Vector2d& masses,
                 double gravity);

  /// The state after `time` [s] >= 0.
  State at(double time) const;
  /// Kinetic and potential energy, zero at rest with both bobs at the pivot's height [J].
  double energy(const State& state) const;

 private:
  State start_;
  Eigen::Vector2d lengths_, masses_;
  double gravity_;
};

}  // namespace byhand
