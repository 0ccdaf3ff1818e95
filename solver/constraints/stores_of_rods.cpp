#include "solver/constraints/distance.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/spring.hpp"

namespace byhand {

BYHAND_STORES(, Distance);
BYHAND_STORES(, NormalisedDistance);
BYHAND_STORES(, Rope);
BYHAND_STORES(, Spring);

}  // namespace byhand
