#include "solver/methods/avbd.hpp"

namespace byhand {

void require_valid(const Avbd& method) {
  require(method.iterations >= 1, "number of iterations", method.iterations, "at least 1");
  require_in("alpha", method.alpha, 0, 1);
  require_in("beta", method.beta, 0, 1e300, "N/m²");
  require_in("memory", method.memory, 0, 1);
  require_positive("softest", method.softest);
  require_positive("stiffest", method.stiffest, "N/m");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

}  // namespace byhand
