// You return the sum of all impulses so far, where V already has the sum from before: return what is new.
#include <algorithm>

#include "practise.hpp"

double clamp_contact(double& accumulated, double delta) {
  accumulated = std::max(0.0, accumulated + delta);
  return accumulated;
}
