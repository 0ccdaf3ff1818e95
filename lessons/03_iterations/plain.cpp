#include "lessons/03_iterations/plain.hpp"

namespace byhand::iterations {

//! [sweep]
void plain_sweep(const ChainOptions& chain, std::vector<double>& v, std::vector<double>& lambda) {
  const double L = chain.length, m = chain.mass;
  for (int i = 0; i < chain.links; ++i) {
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
  for (int i = n - 2; i >= 0; --i) x[i] = (x[i] - beside[i] * x[i + 1]) / diagonal[i];  // and up again
  return x;
}
//! [elimination]

}  // namespace byhand::iterations
