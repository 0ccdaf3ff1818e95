// Right for particles: turn a body and its anchor moves by ω × r. The arm reaches from the centre, not from the
// wheel.
#include "practise.hpp"

double value(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& pulley) {
  const Vec2 d1 = p1 + r1 - pulley.wheel1, d2 = p2 + r2 - pulley.wheel2;
  return length(d1) + pulley.ratio * length(d2) - pulley.L;
}

BodyRow jacobian(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& pulley) {
  const Vec2 d1 = p1 + r1 - pulley.wheel1, d2 = p2 + r2 - pulley.wheel2;
  const Vec2 u1 = d1 / length(d1), u2 = pulley.ratio / length(d2) * d2;
  return {u1, 0, u2, 0};
}
