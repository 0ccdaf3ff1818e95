#include "lessons/laws/law.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

#include "lessons/laws/baumgarte.hpp"
#include "lessons/laws/buckling.hpp"
#include "lessons/laws/creep.hpp"
#include "lessons/laws/doubling.hpp"
#include "lessons/laws/friction.hpp"
#include "lessons/laws/hopping.hpp"
#include "lessons/laws/pop.hpp"
#include "lessons/laws/redundant.hpp"
#include "lessons/laws/soft.hpp"
#include "lessons/laws/spin.hpp"
#include "lessons/laws/sweeps.hpp"
#include "lessons/laws/transverse.hpp"
#include "lessons/laws/tunnelling.hpp"
#include "lessons/laws/warm_start.hpp"
#include "solver/support/require.hpp"

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
          exact_columns(),
          step_doubling()};
}

std::string counted(int count, const std::string& what) {
  return std::to_string(count) + " " + what + (count == 1 ? "" : "s");
}

double bisect(const std::function<bool(double)>& holds, double low, double high, double resolution) {
  require_positive("lower end", low, "");
  const bool held = holds(low);
  if (holds(high) == held)
    throw std::invalid_argument(fmt::format(
        "outcome at both ends is {}, but it must be good at one and bad at the other", held ? "good" : "bad"));
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
