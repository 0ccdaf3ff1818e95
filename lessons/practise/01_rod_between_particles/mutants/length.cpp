// Your C and J belong together, but to the stretch |d| − L; (2) asks for ½(d² − L²).
#include "practise.hpp"

double value(Vec2 p1, Vec2 p2, double L) { return length(p2 - p1) - L; }

ParticleRow jacobian(Vec2 p1, Vec2 p2, double) {
  const Vec2 u = (p2 - p1) / length(p2 - p1);
  return {-u, u};
}
