// The floor pulls: λ is clamped, but V gets all of Δ.
#include <algorithm>

#include "practise.hpp"

double clamp_contact(double& accumulated, double delta) {
  accumulated = std::max(0.0, accumulated + delta);
  return delta;
}
