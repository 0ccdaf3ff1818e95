// Every call forgets the impulses before it: accumulated + Δ is clamped, not Δ.
#include <algorithm>

#include "practise.hpp"

double clamp_contact(double& accumulated, double delta) {
  accumulated = std::max(0.0, delta);
  return accumulated;
}
