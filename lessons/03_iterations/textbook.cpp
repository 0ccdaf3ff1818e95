#include "lessons/03_iterations/textbook.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/LU>

namespace byhand::iterations {

Eigen::MatrixXd textbook_matrix(const ChainOptions& chain) {
  Eigen::MatrixXd A = Eigen::MatrixXd::Zero(chain.links, chain.links);
  for (int i = 0; i < chain.links; ++i) {
    const double below = 1 / (i + 1 == chain.links ? chain.end_mass : chain.mass);
    const double above = i == 0 ? 0 : 1 / chain.mass;
    A(i, i) = above + below;
    if (i > 0) A(i, i - 1) = A(i - 1, i) = -above;
  }
  return A;
}

Eigen::MatrixXd textbook_sweep(const Eigen::MatrixXd& A) {
  const Eigen::MatrixXd lower = A.triangularView<Eigen::Lower>();
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(A.rows(), A.rows());
  return identity - A * lower.triangularView<Eigen::Lower>().solve(identity);
}

double textbook_jacobi_factor(const Eigen::MatrixXd& A) {
  const Eigen::VectorXd scale = A.diagonal().cwiseSqrt().cwiseInverse();
  const Eigen::MatrixXd scaled = scale.asDiagonal() * A * scale.asDiagonal();
  const Eigen::VectorXd mu =
      Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(scaled, Eigen::EigenvaluesOnly).eigenvalues();
  return (1 - mu.array()).abs().maxCoeff();
}

Eigen::VectorXd textbook_cold_errors(const ChainOptions& chain, int sweeps, double fall) {
  const Eigen::MatrixXd one = textbook_sweep(textbook_matrix(chain));
  Eigen::MatrixXd all = one;
  for (int i = 1; i < sweeps; ++i) all = all * one;
  const Eigen::MatrixXd identity = Eigen::MatrixXd::Identity(chain.links, chain.links);
  // r = Gᵏ(r + what gravity adds)
  return (identity - all).partialPivLu().solve(all * (fall * Eigen::VectorXd::Unit(chain.links, 0)));
}

double sweeps_per_digit(double factor) { return std::log(10.0) / -std::log(factor); }

}  // namespace byhand::iterations
