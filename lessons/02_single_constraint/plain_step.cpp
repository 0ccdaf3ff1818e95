#include "lessons/02_single_constraint/plain_step.hpp"

namespace byhand::single_constraint {

//! [step]
void plain_step(Vec2& x, Vec2& v, double m, Vec2 g, double h) {
  v += h * g;                      // gravity, before λ
  const Vec2 d = x;                // (11), the fixed point is at 0
  const double JV = dot(d, v);     // (8)
  const double K = dot(d, d) / m;  // (19)
  const double lambda = -JV / K;   // (17) with b = 0
  v += lambda / m * d;             // (20)
  x += h * v;                      // pose along velocity
}
//! [step]

}  // namespace byhand::single_constraint
