#pragma once

#include "lessons/06_joints/setting.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"

namespace byhand::joints {

inline constexpr double sample_seconds = 1.6;
/// Seconds of the joints in one of the film: bars of all lengths look alike, and √(L/g) is their time.
inline double sample_pace(double length) { return std::sqrt(length / 2); }
inline constexpr double sample_stop = -pi / 3;  // angle of the stop from level [rad]

/// Six bars, each joined to the ground in another way, which move without touching each other.
class Samples {
 public:
  explicit Samples(const Setting& setting);

  /// Draws them `time` [s] after they began; times must not decrease.
  void draw(renderer::Canvas& canvas, double time);

 private:
  using Joined = Simulation<PlaneBody>;

  /// What each joint gives its bar at the hinge: a force [N] and a couple [N m].
  struct Given {
    renderer::Point force{0, 0};
    double couple = 0;
  };
  std::array<Given, 6> given() const;

  double length_, weight_, h_;
  Joined simulation_;
};

}  // namespace byhand::joints
