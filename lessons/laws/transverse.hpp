#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// A hanging chain whose bobs are off to the side by about a hundred-millionth of a metre.
struct TautChain {
  int links = 6;
  double mass = 1, length = 1;  // of a link [kg, m]
  double end_mass = 100;        // [kg]
  double step = 1.0 / 60;       // [s]
  int substeps = 1;
  int sweeps = 0;  // of Gauss–Seidel; 0 solves each step exactly
  double beta = 0.2;
};
/// Settles as long as it swings no wider than a thousand times as far as at first: a chain does swing. What swings
/// wider explodes, or rings where its links' own stretch holds it.
Outcome run(const TautChain& chain);

/// The heaviest end that this chain bears [kg].
double heaviest_end(const TautChain& chain);

/// T h²/(ml) at which many light links under the tension T blow up [1]: of bobs on rods without mass, and of
/// uniform rods that are pinned to each other.
inline constexpr double limit_of_bobs = 1, limit_of_rods = 1.0 / 3;

/// Law 7: what hangs taut is an explicit spring sideways.
Law transverse();

}  // namespace byhand::laws
