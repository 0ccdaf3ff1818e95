#include "lessons/exact/spectral_radius.hpp"

#include <cmath>

namespace byhand {

double spectral_radius(Eigen::MatrixXd M) {
  double log_radius = 0;
  for (double share = 1; share > 1e-18; share /= 2) {  // M is squared: n doubles
    const double size = M.norm();
    if (size == 0) return 0;
    log_radius += share * std::log(size);
    M /= size;
    M = M.lazyProduct(M).eval();
  }
  return std::exp(log_radius);
}

}  // namespace byhand
