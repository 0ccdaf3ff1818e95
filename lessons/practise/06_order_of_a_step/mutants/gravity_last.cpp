// Gravity after the impulse stays unanswered for a step: a hanging bob sinks at g·h.
#include "practise.hpp"

void step(Pendulum& pendulum, double h) {
  Vec2 &p = pendulum.p, &v = pendulum.v;
  const Vec2 J = p;
  const double lambda = -dot(J, v) * pendulum.m / dot(J, J);
  v += lambda / pendulum.m * J;
  v.y -= pendulum.g * h;
  p += h * v;
}
