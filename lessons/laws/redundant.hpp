#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// A bob of 3 kg at rest under two rods of 2 m between the same points, one of them longer by `conflict` [m].
struct ConflictingRods {
  double conflict = 0.2, beta = 0.2;
  int sweeps = 10;      // 0: a direct solve
  double softness = 0;  // γ of both [1/kg]
  double step = 1.0 / 60;
};
/// The difference of their two pulls after `time` [N]. Throws SingularSystem where no sweeps, but a direct solve
/// is asked for and nothing is soft.
double pull_apart(const ConflictingRods& rods, double time);
/// How far the bob gets from its start in that time [m].
double bob_moves(const ConflictingRods& rods, double time);

/// Law 8: rows that repeat or contradict each other.
Law conflicting_rows();

}  // namespace byhand::laws
