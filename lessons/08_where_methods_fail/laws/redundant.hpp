#pragma once

#include "lessons/08_where_methods_fail/laws/law.hpp"

namespace byhand::laws {

/// A bob of 3 kg at rest under two rods of 2 m between the same points, one of them longer by `conflict` [m].
struct ConflictingRods {
  double conflict = 0.2, beta = 0.2;
  int sweeps = 10;
  double softness = 0;  // γ of both [1/kg]
  double step = 1.0 / 60;
};
/// The difference of their two pulls after `time` [N].
double pull_apart(const ConflictingRods& rods, double time);

/// Law 8: rows that repeat or contradict each other.
Law conflicting_rows();

}  // namespace byhand::laws
