#include "lessons/laws/spectral_radius.hpp"

#include <Eigen/Eigenvalues>

namespace byhand::laws {

double spectral_radius(const Eigen::MatrixXd& matrix) { return matrix.eigenvalues().cwiseAbs().maxCoeff(); }

}  // namespace byhand::laws
