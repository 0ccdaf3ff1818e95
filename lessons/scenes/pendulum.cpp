#include "lessons/scenes/pendulum.hpp"

namespace byhand {

template Scene<PlaneParticle, Distance> pendulum(double, double, double);
template Scene<PlaneParticle, NormalisedDistance> pendulum(double, double, double);
template Scene<PlaneBody, Distance> pendulum(double, double, double);
template Scene<PlaneBody, NormalisedDistance> pendulum(double, double, double);
template Scene<SpaceParticle, Distance> pendulum(double, double, double);
template Scene<SpaceParticle, NormalisedDistance> pendulum(double, double, double);
template Scene<SpaceBody, Distance> pendulum(double, double, double);
template Scene<SpaceBody, NormalisedDistance> pendulum(double, double, double);
template Scene<PlaneBody, Pin> hinged_rod(double, double, double);
template Scene<SpaceBody, Pin> hinged_rod(double, double, double);

}  // namespace byhand
