#include "solver/integrate/euler.hpp"

namespace byhand {

double mean_decay(double x) {
  if (x > 64) return 1 / x;  // exp(-x) is less than rounding
  int doublings = 0;
  for (; x > 1.0 / 16; x /= 2) ++doublings;
  double mean = 1;
  for (int n = 10; n > 1; --n) mean = 1 - x * mean / n;
  for (; doublings > 0; --doublings, x *= 2) mean *= 1 - x * mean / 2;  // exp(-2x) = exp(-x)²
  return mean;
}

}  // namespace byhand
