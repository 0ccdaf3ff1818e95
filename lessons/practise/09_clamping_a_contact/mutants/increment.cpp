// You clamp the increment, not the sum: a row may never take back what it gave too much, and the box hops.
#include <algorithm>

#include "practise.hpp"

double clamp_contact(double& accumulated, double delta) {
  const double applied = std::max(0.0, delta);
  accumulated += applied;
  return applied;
}
