#include "solver/constraints/hinge.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"

namespace byhand {

#define BYHAND_STORE(M, Kind) template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M>>()
#define BYHAND_INSTANTIATE(M) BYHAND_STORE(M, Pin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
BYHAND_STORE(PlaneBody, Slider);
BYHAND_STORE(SpaceBody, Slider);
BYHAND_STORE(PlaneBody, Weld);
BYHAND_STORE(SpaceBody, Weld);
BYHAND_STORE(SpaceBody, Hinge);

}  // namespace byhand
