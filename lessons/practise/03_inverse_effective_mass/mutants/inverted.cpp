// This is the effective mass 1/K; (19) is its inverse, and (17) divides by it.
#include "practise.hpp"

double inverse_effective_mass(const BodyRow& J, double m1, double I1, double m2, double I2) {
  return 1 / (dot(J.l1, J.l1) / m1 + J.a1 * J.a1 / I1 + dot(J.l2, J.l2) / m2 + J.a2 * J.a2 / I2);
}
