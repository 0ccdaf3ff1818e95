// Your C is the stretch |d| − L and your J belongs to ½(d² − L²): each is right, together β acts as β·L.
#include "practise.hpp"

double value(Vec2 p1, Vec2 p2, double L) {
  const Vec2 d = p2 - p1;
  return length(d) - L;
}

ParticleRow jacobian(Vec2 p1, Vec2 p2, double) {
  const Vec2 d = p2 - p1;
  return {-d, d};
}
