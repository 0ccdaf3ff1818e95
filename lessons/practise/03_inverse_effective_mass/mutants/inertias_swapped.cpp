// Each body turns with its own moment of inertia: you divide a1 by I2 and a2 by I1.
#include "practise.hpp"

double inverse_effective_mass(const BodyRow& J, double m1, double I1, double m2, double I2) {
  return dot(J.l1, J.l1) / m1 + J.a1 * J.a1 / I2 + dot(J.l2, J.l2) / m2 + J.a2 * J.a2 / I1;
}
