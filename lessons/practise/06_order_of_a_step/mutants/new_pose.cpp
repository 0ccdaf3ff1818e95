// J and V belong to different moments: J is taken where the bob will be, V where it is.
#include "practise.hpp"

void step(Pendulum& pendulum, double h) {
  Vec2 &p = pendulum.p, &v = pendulum.v;
  v.y -= pendulum.g * h;
  const Vec2 J = p + h * v;
  const double lambda = -dot(J, v) * pendulum.m / dot(J, J);
  v += lambda / pendulum.m * J;
  p += h * v;
}
