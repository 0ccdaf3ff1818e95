#include "lessons/exact/slider_crank.hpp"

#include <cmath>

#include "solver/support/require.hpp"

namespace byhand {

SliderCrank::SliderCrank(double crank, double rod) : crank_(crank), rod_(rod) {
  require_positive("the crank's length", crank, "m");
  require_positive("the rod's length", rod, "m");
  require(rod > crank, "the rod's length", rod, "above the crank's, or it cannot turn over");
}

double SliderCrank::position(double angle) const {
  const double y = crank_ * std::sin(angle);
  return crank_ * std::cos(angle) + std::sqrt((rod_ - y) * (rod_ + y));
}

double SliderCrank::speed(double angle) const {
  const double x = crank_ * std::cos(angle), y = crank_ * std::sin(angle);
  return -y - x * y / std::sqrt((rod_ - y) * (rod_ + y));
}

// With s = √(l² - y²) and y' = x, x' = -y: s' = -xy/s and s'' = (y² - x² - s'²)/s.
double SliderCrank::acceleration(double angle) const {
  const double x = crank_ * std::cos(angle), y = crank_ * std::sin(angle);
  const double reach = std::sqrt((rod_ - y) * (rod_ + y)), slope = -x * y / reach;
  return -x + (y * y - x * x - slope * slope) / reach;
}

}  // namespace byhand
