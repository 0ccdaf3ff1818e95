#include "solver/support/compiled.hpp"

namespace byhand {

BYHAND_COMPILED();

}  // namespace byhand
