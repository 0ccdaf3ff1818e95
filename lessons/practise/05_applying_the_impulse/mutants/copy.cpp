// V is unchanged: you changed a copy of it, or nothing.
#include "practise.hpp"

void apply_impulse(Velocities& V, const BodyRow& J, double lambda, InverseMasses W) {
  Velocities copy = V;
  copy.v1 += lambda * W.m1 * J.l1;
  copy.w1 += lambda * W.I1 * J.a1;
  copy.v2 += lambda * W.m2 * J.l2;
  copy.w2 += lambda * W.I2 * J.a2;
}
