#include "lessons/03_iterations/plain_sweep.hpp"

#include <cstddef>

namespace byhand::iterations {

//! [sweep]
void plain_sweep(double L, double m, std::span<double> v, std::span<double> lambda) {
  for (std::size_t i = 0; i < v.size(); ++i) {
    const double above = i == 0 ? 0 : v[i - 1];     // the fixed point does not move
    const double JV = L * (v[i] - above);           // (8)
    const double K = L * L * (i == 0 ? 1 : 2) / m;  // (19)
    const double change = -JV / K;                  // (17)
    lambda[i] += change;
    v[i] += change * L / m;                 // (20), the bob below
    if (i > 0) v[i - 1] -= change * L / m;  // (20), the bob above
  }
}
//! [sweep]

}  // namespace byhand::iterations
