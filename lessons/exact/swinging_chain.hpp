#pragma once

#include <Eigen/Core>
#include <vector>

namespace byhand {

/// A chain in the plane whose links turn about the ends of those above them, the first about the origin:
/// integrated in the links' angles from straight down, so that no constraint is there to drift. A bob on a
/// massless rod is a link whose centre is its end and that has no inertia.
///
/// Each derivative costs time proportional to the number of links, by Featherstone's articulated bodies (Rigid
/// Body Dynamics Algorithms, 2008, §7.3) with one angle a joint.
class SwingingChain {
 public:
  struct Link {
    double length = 1;   // between its joints [m]
    double centre = 1;   // from its upper joint to its centre of mass [m]
    double mass = 1;     // [kg]
    double inertia = 0;  // about its centre [kg m²]
  };
  struct State {
    std::vector<Eigen::Vector2d> positions, velocities;  // of the centres [m, m/s]
    double uncertainty = 0;  // largest error expected in an angle or its rate [rad, rad/s]
  };

  /// From rest with all links at `angle` [rad]; `gravity` in m/s². Throws std::invalid_argument unless the angle
  /// is finite, there are links, their inertia >= 0 and all else is positive.
  SwingingChain(std::vector<Link> links, double angle, double gravity);

  /// The state after `time` [s] >= 0, integrated to the relative `tolerance`.
  State at(double time, double tolerance = 1e-11) const;

 private:
  std::vector<Link> links_;
  double angle_, gravity_;
};

}  // namespace byhand
