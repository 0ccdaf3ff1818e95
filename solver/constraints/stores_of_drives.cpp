#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"

namespace byhand {

BYHAND_STORES_OF_FREEDOMS(, Limit);
BYHAND_STORES_OF_FREEDOMS(, Motor);
BYHAND_STORES_OF_FREEDOMS(, Servo);

}  // namespace byhand
