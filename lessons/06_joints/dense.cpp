#include "lessons/06_joints/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/SVD>

namespace byhand::joints {

int rank(const Eigen::MatrixXd& matrix) {
  const Eigen::VectorXd values = Eigen::JacobiSVD<Eigen::MatrixXd>(matrix).singularValues();
  return static_cast<int>((values.array() > 1e-9 * values[0]).count());
}

double least_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace byhand::joints
