#include "solver/methods/xpbd.hpp"

namespace byhand {

void require_valid(const Xpbd& method) {
  require(method.substeps >= 1, "number of substeps", method.substeps, "at least 1");
  require(method.iterations >= 1, "number of iterations", method.iterations, "at least 1");
  require(method.push_speed > 0, "push speed", method.push_speed, "above zero [m/s]");
  require_in("bounce threshold", method.bounce_threshold, 0, 1e300, "m/s");
}

}  // namespace byhand
