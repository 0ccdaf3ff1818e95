// That is explicit Euler: the bob moves by the old velocity, and energy grows.
#include "practise.hpp"

void step(Pendulum& pendulum, double h) {
  Vec2 &p = pendulum.p, &v = pendulum.v;
  const Vec2 J = p;
  p += h * v;
  v.y -= pendulum.g * h;
  const double lambda = -dot(J, v) * pendulum.m / dot(J, J);
  v += lambda / pendulum.m * J;
}
