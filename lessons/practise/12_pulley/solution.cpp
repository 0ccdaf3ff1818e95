#include "practise.hpp"

double value(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& pulley) {
  const Vec2 d1 = p1 + r1 - pulley.wheel1, d2 = p2 + r2 - pulley.wheel2;
  return length(d1) + pulley.ratio * length(d2) - pulley.L;
}

BodyRow jacobian(Vec2 p1, Vec2 r1, Vec2 p2, Vec2 r2, const Pulley& pulley) {
  const Vec2 d1 = p1 + r1 - pulley.wheel1, d2 = p2 + r2 - pulley.wheel2;
  const Vec2 u1 = d1 / length(d1), u2 = pulley.ratio / length(d2) * d2;
  return {u1, cross(r1, u1), u2, cross(r2, u2)};
}
