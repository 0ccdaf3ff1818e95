#pragma once

#include <Eigen/Core>

namespace byhand {

/// The largest size of an eigenvalue of a square matrix, by Gelfand's formula: the limit of |Mⁿ|^(1/n).
double spectral_radius(Eigen::MatrixXd M);

}  // namespace byhand
