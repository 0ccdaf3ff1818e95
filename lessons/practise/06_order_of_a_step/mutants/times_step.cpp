// λ is an impulse already; multiplied by h it hardly holds the bob.
#include "practise.hpp"

void step(Pendulum& pendulum, double h) {
  Vec2 &p = pendulum.p, &v = pendulum.v;
  v.y -= pendulum.g * h;
  const Vec2 J = p;
  const double lambda = -dot(J, v) * pendulum.m / dot(J, J);
  v += h * lambda / pendulum.m * J;
  p += h * v;
}
