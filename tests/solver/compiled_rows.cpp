#include "solver/support/each_model.hpp"
#include "tests/solver/compiled.hpp"

namespace byhand {

#define COMPILE_HERE(M) BYHAND_COMPILE_ROWS(, M)

BYHAND_FOR_EACH_MODEL(COMPILE_HERE);

}  // namespace byhand
