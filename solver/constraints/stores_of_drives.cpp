#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"

namespace byhand {

BYHAND_STORES_OF_FREEDOMS(, Limit);
BYHAND_STORE_OF_FREEDOM(SpaceBody, Limit, Swing);
BYHAND_STORES_OF_FREEDOMS(, Motor);
BYHAND_STORES_OF_FREEDOMS(, Servo);

}  // namespace byhand
