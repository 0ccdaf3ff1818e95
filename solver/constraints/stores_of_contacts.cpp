#include "solver/constraints/axis_friction.hpp"
#include "solver/constraints/contact_manifold.hpp"

namespace byhand {

#define BYHAND_STORE(M, Kind) template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M>>()
#define BYHAND_INSTANTIATE(M) \
  BYHAND_STORE(M, Contact);   \
  BYHAND_STORE(M, Friction);  \
  BYHAND_STORE(M, AxisFriction)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
BYHAND_STORE(PlaneBody, ContactManifold);

}  // namespace byhand
