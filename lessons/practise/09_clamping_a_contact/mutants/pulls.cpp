// Your floor only pulls: the accumulated impulse must stay ≥ 0, not ≤ 0.
#include <algorithm>

#include "practise.hpp"

double clamp_contact(double& accumulated, double delta) {
  const double before = accumulated;
  accumulated = std::min(0.0, before + delta);
  return accumulated - before;
}
