#pragma once

#include <Eigen/Core>

namespace byhand::laws {

/// The largest modulus of an eigenvalue of a square matrix: what it does to a disturbance in the long run.
double spectral_radius(const Eigen::MatrixXd& matrix);

}  // namespace byhand::laws
