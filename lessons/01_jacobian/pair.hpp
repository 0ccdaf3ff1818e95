#pragma once

#include "lessons/01_jacobian/steps.hpp"
#include "solver/constraints/distance.hpp"

namespace byhand::lesson01 {

/// Two boxes in the plane, joined corner to corner by a rod, and how they move: what this lesson differentiates.
struct Pair {
  Distance<PlaneBody> rod;
  Pose<PlaneBody> pose1, pose2;
  Velocity<PlaneBody> V1, V2;

  /// The same after `time` [s] of moving with constant V1 and V2; nothing holds them.
  Pair after(double time) const;

  double value() const { return rod.value<double>(pose1, pose2)[0]; }        // C of (2) [m²]
  Jacobian<PlaneBody, 1> row() const { return rod.jacobian(pose1, pose2); }  // J of (14)
  double rate() const { return dot(row(), V1, V2)[0]; }                      // JV of (8) [m²/s]
  Linear<PlaneBody> r1() const { return in_world<PlaneBody, double>(pose1, rod.at.arms.first); }
  Linear<PlaneBody> r2() const { return in_world<PlaneBody, double>(pose2, rod.at.arms.second); }
  Linear<PlaneBody> d() const { return rod.at.separation<double>(pose1, pose2); }  // (11) [m]
  /// C̈ along the motion, by differentiating (10) once more [m²/s²].
  double second_rate() const;
  /// A bound on the third time derivative of C within `time` [s] from here, either way [m²/s³].
  double third_rate_bound(double time) const;
};

/// The pair of steps 2 to 5: the rod is `stretch` too long.
Pair pair_of(const Settings& set);

/// An upper bound of the speed of an end, of a centre and of the turning [m/s].
double fastest(const Settings& set);

/// How long the pair is watched [s]: it moves by about a rod's length and turns by less than a turn.
double watched(const Settings& set);

/// Full side lengths of a box of the pair [m].
Linear<PlaneBody> box_sides(const Settings& set);

/// dC/dt by the centred difference over ±`step` [s].
double difference(const Pair& pair, double step);

/// How far `difference` may lie from JV: by Taylor step²/6 of the third derivative, and the rounding of C.
double difference_tolerance(const Pair& pair, double step);

/// What rounding may leave in a value of C of this pair within `time` [m²].
double rounding(const Pair& pair, double time);

}  // namespace byhand::lesson01
