#include "lessons/methods/row_solvers.hpp"

#include "solver/advance.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template void require_valid(const AnyStepping&);

#define BYHAND_INSTANTIATE(M) BYHAND_STEPPING(M, AnyRowSolver, DriftCure)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
