#include "solver/work.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

BYHAND_DEFINE_COPIES(StepWork)

#define BYHAND_INSTANTIATE(M) template struct StepWork<M>
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
