#include "solver/constraints/contact_manifold.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/constraints/weld.hpp"
#include "solver/support/each_model.hpp"

// The stores of the library's kinds, compiled once.
namespace byhand {

#define BYHAND_STORES_OF_ALL(M)        \
  BYHAND_STORE(M, Contact);            \
  BYHAND_STORE(M, Distance);           \
  BYHAND_STORE(M, Friction);           \
  BYHAND_STORE(M, NormalisedDistance); \
  BYHAND_STORE(M, Pin);                \
  BYHAND_STORE(M, Rope);               \
  BYHAND_STORE(M, Spring)
BYHAND_FOR_EACH_MODEL(BYHAND_STORES_OF_ALL);

#define BYHAND_STORES_OF_TURNING(M)         \
  BYHAND_STORE_OF_FREEDOM(M, Limit, Slide); \
  BYHAND_STORE_OF_FREEDOM(M, Limit, Turn);  \
  BYHAND_STORE_OF_FREEDOM(M, Motor, Slide); \
  BYHAND_STORE_OF_FREEDOM(M, Motor, Turn);  \
  BYHAND_STORE_OF_FREEDOM(M, Servo, Slide); \
  BYHAND_STORE_OF_FREEDOM(M, Servo, Turn);  \
  BYHAND_STORE(M, Slider);                  \
  BYHAND_STORE(M, Weld)
BYHAND_FOR_EACH_TURNING_MODEL(BYHAND_STORES_OF_TURNING);

#define BYHAND_STORES_OF_SPACE(M) BYHAND_STORE(M, AxisFriction)
BYHAND_FOR_SPACE_PARTICLE(BYHAND_STORES_OF_SPACE)
BYHAND_FOR_SPACE_BODY(BYHAND_STORES_OF_SPACE)

#ifdef BYHAND_PLANE_BODY
BYHAND_STORE(PlaneBody, ContactManifold);
#endif
#ifdef BYHAND_SPACE_BODY
BYHAND_STORE(SpaceBody, Hinge);
BYHAND_STORE_OF_FREEDOM(SpaceBody, Limit, Swing);
#endif

}  // namespace byhand
