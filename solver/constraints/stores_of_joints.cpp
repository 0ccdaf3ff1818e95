#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"

namespace byhand {

BYHAND_STORES(, Pin);
BYHAND_STORES_OF_BODIES(, Slider);
BYHAND_STORES_OF_BODIES(, Weld);
BYHAND_STORE(SpaceBody, Hinge);
BYHAND_STORES_OF_FREEDOMS(, Limit);
BYHAND_STORES_OF_FREEDOMS(, Motor);
BYHAND_STORES_OF_FREEDOMS(, Servo);

}  // namespace byhand
