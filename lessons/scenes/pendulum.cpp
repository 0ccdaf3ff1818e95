#include "lessons/scenes/pendulum.hpp"

namespace byhand {

template Scene<PlaneParticle> pendulum<PlaneParticle, Distance>(double, double, double);
template Scene<PlaneParticle> pendulum<PlaneParticle, NormalisedDistance>(double, double, double);
template Scene<PlaneBody> pendulum<PlaneBody, Distance>(double, double, double);
template Scene<PlaneBody> pendulum<PlaneBody, NormalisedDistance>(double, double, double);
template Scene<SpaceParticle> pendulum<SpaceParticle, Distance>(double, double, double);
template Scene<SpaceParticle> pendulum<SpaceParticle, NormalisedDistance>(double, double, double);
template Scene<SpaceBody> pendulum<SpaceBody, Distance>(double, double, double);
template Scene<SpaceBody> pendulum<SpaceBody, NormalisedDistance>(double, double, double);
template Scene<PlaneBody> hinged_rod<PlaneBody>(double, double, double);
template Scene<SpaceBody> hinged_rod<SpaceBody>(double, double, double);

}  // namespace byhand
