// Your C and J belong together, but to d² − L²; (2) has the factor ½, so that J has no 2.
#include "practise.hpp"

double value(Vec2 p1, Vec2 p2, double L) { return dot(p2 - p1, p2 - p1) - L * L; }

ParticleRow jacobian(Vec2 p1, Vec2 p2, double) {
  const Vec2 d = p2 - p1;
  return {-2 * d, 2 * d};
}
