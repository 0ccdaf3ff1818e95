#pragma once

#include "lessons/laws/law.hpp"

namespace byhand {
enum class SweepOrder;
}

namespace byhand::laws {

/// A straight chain of unit links without weight, each bob off by about a ten-millionth of a link along it.
struct WarmChain {
  int links = 10, sweeps = 1;  // no sweeps: each step is solved exactly
  double beta = 0.2;
  bool warm_start = true;
  SweepOrder order = {};  // natural
  int substeps = 1;
  int steps = 4500;  // fewer are enough away from the boundary
};
Outcome run(const WarmChain& chain);

/// Law 6: warm start with Baumgarte.
Law warm_start();

}  // namespace byhand::laws
