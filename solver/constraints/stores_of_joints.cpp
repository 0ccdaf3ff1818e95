#include "solver/constraints/hinge.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"

namespace byhand {

BYHAND_STORES(, Pin);
BYHAND_STORES_OF_BODIES(, Slider);
BYHAND_STORES_OF_BODIES(, Weld);
BYHAND_STORE(SpaceBody, Hinge);

}  // namespace byhand
