#include "lessons/06_joints/dense.hpp"

#include <Eigen/Eigenvalues>
#include <Eigen/QR>

#include "solver/direct/graph.hpp"
#include "solver/scene.hpp"

namespace byhand::joints {

namespace {

/// The diagonal of M⁻¹ of (18) for the columns of `dense_jacobian`.
Eigen::VectorXd dense_inverse_mass(const Bodies<PlaneBody>& bodies) {
  std::vector<double> diagonal;
  for (const InverseMass<PlaneBody>& mass : bodies.inverse_mass)
    if (moves(mass)) diagonal.insert(diagonal.end(), {mass.linear, mass.linear, mass.angular[0]});
  return Eigen::Map<const Eigen::VectorXd>(diagonal.data(), static_cast<Eigen::Index>(diagonal.size()));
}

}  // namespace

Eigen::MatrixXd dense_jacobian(const Scene<PlaneBody>& scene) {
  const Bodies<PlaneBody>& bodies = scene.bodies();
  std::vector<int> column(bodies.size(), -1);
  int columns = 0;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) column[i] = PlaneBody::dof * columns++;
  System<PlaneBody> system;
  scene.lay_out(natural_order(scene.count()), system);
  scene.write_rows(system, 1);
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(system.rows(), PlaneBody::dof * columns);
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<PlaneBody, K, B>> blocks) {
    for (const auto& block : blocks) {
      if (block.moves1) J.block<K, PlaneBody::dof>(block.row, column[block.body1]) = block.J.side1();
      if (block.moves2) J.block<K, PlaneBody::dof>(block.row, column[block.body2]) = block.J.side2();
    }
  });
  return J;
}

Eigen::MatrixXd dense_matrix(const Scene<PlaneBody>& scene) {
  const Eigen::MatrixXd J = dense_jacobian(scene);
  return J * dense_inverse_mass(scene.bodies()).asDiagonal() * J.transpose();
}

int rank(const Eigen::MatrixXd& matrix) {
  return static_cast<int>(Eigen::ColPivHouseholderQR<Eigen::MatrixXd>(matrix).setThreshold(1e-9).rank());
}

double least_eigenvalue(const Eigen::MatrixXd& matrix) {
  return Eigen::SelfAdjointEigenSolver<Eigen::MatrixXd>(matrix, Eigen::EigenvaluesOnly).eigenvalues()[0];
}

}  // namespace byhand::joints
