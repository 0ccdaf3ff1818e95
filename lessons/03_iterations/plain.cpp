#include "lessons/03_iterations/plain.hpp"

namespace byhand::iterations {

//! [elimination]
std::vector<double> plain_elimination(std::vector<double> diagonal, const std::vector<double>& beside,
                                      std::vector<double> x) {
  const auto n = static_cast<int>(x.size());
  for (int i = 1; i < n; ++i) {  // down: row i loses its entry left of the diagonal
    const double part = beside[i - 1] / diagonal[i - 1];
    diagonal[i] -= part * beside[i - 1];
    x[i] -= part * x[i - 1];
  }
  x[n - 1] /= diagonal[n - 1];
  for (int i = n - 2; i >= 0; --i) x[i] = (x[i] - beside[i] * x[i + 1]) / diagonal[i];  // substitute back
  return x;
}
//! [elimination]

}  // namespace byhand::iterations
