// You wrote 9.81 where the pendulum has its own g: pendulum.g.
#include "practise.hpp"

void step(Pendulum& pendulum, double h) {
  Vec2 &p = pendulum.p, &v = pendulum.v;
  v.y -= 9.81 * h;
  const Vec2 J = p;
  const double lambda = -dot(J, v) * pendulum.m / dot(J, J);
  v += lambda / pendulum.m * J;
  p += h * v;
}
