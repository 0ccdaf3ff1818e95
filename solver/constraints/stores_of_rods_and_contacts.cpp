#include "solver/constraints/contact_manifold.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/spring.hpp"

namespace byhand {

BYHAND_STORES(, Distance);
BYHAND_STORES(, NormalisedDistance);
BYHAND_STORES(, Rope);
BYHAND_STORES(, Spring);
BYHAND_STORES(, Contact);
BYHAND_STORES(, Friction);
BYHAND_STORE(SpaceParticle, AxisFriction);
BYHAND_STORE(SpaceBody, AxisFriction);
BYHAND_STORE(PlaneBody, ContactManifold);

}  // namespace byhand
