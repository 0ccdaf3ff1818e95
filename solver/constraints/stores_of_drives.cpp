#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/servo.hpp"

namespace byhand {

#define BYHAND_STORE(M, Kind) template std::unique_ptr<ConstraintStore<M>> make_store<M, Kind<M>>()
BYHAND_STORE(PlaneBody, AngleLimit);
BYHAND_STORE(SpaceBody, AngleLimit);
BYHAND_STORE(PlaneBody, SlideLimit);
BYHAND_STORE(SpaceBody, SlideLimit);
BYHAND_STORE(PlaneBody, AngleMotor);
BYHAND_STORE(SpaceBody, AngleMotor);
BYHAND_STORE(PlaneBody, SlideMotor);
BYHAND_STORE(SpaceBody, SlideMotor);
BYHAND_STORE(PlaneBody, AngleServo);
BYHAND_STORE(SpaceBody, AngleServo);
BYHAND_STORE(PlaneBody, SlideServo);
BYHAND_STORE(SpaceBody, SlideServo);

}  // namespace byhand
