#include "solver/constraints/contact_manifold.hpp"
#include "solver/constraints/friction.hpp"

namespace byhand {

BYHAND_STORES(, Contact);
BYHAND_STORES(, Friction);
BYHAND_STORE(SpaceParticle, AxisFriction);
BYHAND_STORE(SpaceBody, AxisFriction);
BYHAND_STORE(PlaneBody, ContactManifold);

}  // namespace byhand
