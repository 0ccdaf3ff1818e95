#include "solver/constraints/compiled.hpp"

namespace byhand {

BYHAND_COMPILED();

}  // namespace byhand
