#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// By how much the wobble of a top with moments 1, 2 and 3 kg m², which turns at `spin` [rad/s] about its axis 0
/// (of the least moment) or 2 (of the largest) and a ten-thousandth of that about another, has grown after `time`
/// [s].
double wobble_growth(int axis, double spin, double step, double time, bool implicit = false);

/// The spin [rad/s] at which an explicit gyroscopic term makes it grow tenfold in that time.
double spin_of_tenfold_wobble(int axis, double step, double time);

/// How far a step leaves the hinge of a weightless rod, `arm` [m] from its centre, that turns by `turn` [rad] in
/// it.
double hinge_error(double turn, double arm);

/// Law 13: what turns too far in a step.
Law spin();

/// A pin that holds a small box by a long arm, at 45° and weightless, off by a ten-millionth of a metre.
struct LongArm {
  double side = 0.1, arm = 1;  // [m]
  double beta = 0.2;
  int sweeps = 10;
  bool block = false;  // the pin's two rows at once
};
Outcome run(const LongArm& box);

/// What one sweep, row by row, leaves of the error of that pin's two rows.
double left_by_a_sweep(const LongArm& box);

/// Law 15: a pin's rows one by one, or as a block.
Law block_or_rows();

}  // namespace byhand::laws
