#include "solver/laws/law.hpp"

#include <cmath>
#include <limits>

#include "solver/laws/baumgarte.hpp"
#include "solver/laws/buckling.hpp"
#include "solver/laws/creep.hpp"
#include "solver/laws/friction.hpp"
#include "solver/laws/hopping.hpp"
#include "solver/laws/pop.hpp"
#include "solver/laws/redundant.hpp"
#include "solver/laws/soft.hpp"
#include "solver/laws/spin.hpp"
#include "solver/laws/sweeps.hpp"
#include "solver/laws/transverse.hpp"
#include "solver/laws/tunnelling.hpp"
#include "solver/laws/warm_start.hpp"
#include "solver/require.hpp"

namespace byhand::laws {

std::vector<Law> all() {
  return {one_row(),
          pop(),
          uncorrected_drift(),
          slow_sweeps(),
          jacobi_overshoots(),
          warm_start(),
          transverse(),
          conflicting_rows(),
          heavy_on_light(),
          friction(),
          springs(),
          substeps(),
          spin(),
          stale_rows(),
          block_or_rows(),
          tunnelling(),
          buckling(),
          creep(),
          hopping(),
          exact_columns()};
}

std::string counted(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

double bisect(const std::function<bool(double)>& holds, double low, double high, double resolution) {
  require_positive("lower end", low, "");
  const bool held = holds(low);
  require(holds(high) != held, "outcome at both ends", held ? "good" : "bad", "good at one and bad at the other");
  while (high / low > 1 + resolution) {
    const double middle = std::sqrt(low * high);
    (holds(middle) == held ? low : high) = middle;
  }
  return std::sqrt(low * high);
}

Boundary bisected(Boundary boundary) {
  boundary.measured = [holds = boundary.holds, at = boundary.predicted, tolerance = boundary.tolerance] {
    for (double width = 1 + 2 * tolerance; width < 8; width *= width)
      if (holds(at / width) != holds(at * width)) return bisect(holds, at / width, at * width, tolerance / 5);
    return std::numeric_limits<double>::quiet_NaN();
  };
  return boundary;
}

}  // namespace byhand::laws
