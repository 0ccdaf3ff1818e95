#include <algorithm>

#include "practise.hpp"

double clamp_contact(double& accumulated, double delta) {
  const double before = accumulated;
  accumulated = std::max(0.0, before + delta);
  return accumulated - before;
}
