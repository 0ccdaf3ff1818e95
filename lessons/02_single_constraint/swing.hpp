#pragma once

#include "lessons/02_single_constraint/setting.hpp"

namespace byhand::single_constraint {

/// A pendulum at the beginning of a step, and what that step will do.
struct Sample {
  double time;  // [s]
  Vector position, velocity;
  double C;        // (2) [m²]
  double energy;   // kinetic and potential, zero at rest at the held point's height [J]
  double tension;  // −λ|d|/h of the step [N]
  double thrown;   // ½m|ΔV|² of the step [J]

  double angle() const { return std::atan2(position.x(), -position.y()); }  // from straight down, [rad]
};
using Swing = std::vector<Sample>;

/// The article's step for one row: (17) solves it, so one cold sweep is exact. Nothing cures its drift.
inline VelocityStepping one_row_solved() { return {GaussSeidel{.sweeps = 1, .warm_start = false}, NoDriftCure{}}; }

/// The bob let go at the lesson's `release` and stepped for `seconds` with time step h, the last moment included.
Swing swing(const Setting& setting, double h, double seconds);
Swing swing(Pendulum scene, double h, double seconds);

}  // namespace byhand::single_constraint
