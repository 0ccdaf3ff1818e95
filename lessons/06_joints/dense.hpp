#pragma once

#include <Eigen/Core>

#include "solver/scene.hpp"

// A scene's rows as a textbook writes them, as dense matrices: what the lesson counts and looks at.
namespace byhand::joints {

/// J of all rows over all bodies, fixed ones left out, as the scene now stands.
template <class S>
Eigen::MatrixXd dense_jacobian(const S& scene) {
  using M = typename S::model;
  const Bodies<M>& bodies = scene.bodies();
  std::vector<int> column(bodies.size(), -1);
  int columns = 0, rows = 0;
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) column[i] = M::dof * columns++;
  scene.for_each([&](const auto& constraint) { rows += std::remove_cvref_t<decltype(constraint)>::rows; });
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(rows, M::dof * columns);
  int row = 0;
  scene.for_each([&]<class Kind>(const Kind& constraint) {
    const int body1 = constraint.at.body1, body2 = constraint.at.body2;
    const auto block = constraint.jacobian(bodies.pose[body1], bodies.pose[body2]);
    if (column[body1] >= 0) J.block<Kind::rows, M::dof>(row, column[body1]) = block.side1();
    if (column[body2] >= 0) J.block<Kind::rows, M::dof>(row, column[body2]) = block.side2();
    row += Kind::rows;
  });
  return J;
}

/// The diagonal of M⁻¹ of (18) for the columns of `dense_jacobian`, in the plane.
template <class M>
Eigen::VectorXd dense_inverse_mass(const Bodies<M>& bodies) {
  std::vector<double> diagonal;
  for (const InverseMass<M>& mass : bodies.inverse_mass)
    if (moves(mass)) diagonal.insert(diagonal.end(), {mass.linear, mass.linear, mass.angular[0]});
  return Eigen::Map<const Eigen::VectorXd>(diagonal.data(), static_cast<Eigen::Index>(diagonal.size()));
}

/// A = JM⁻¹Jᵀ of all rows.
template <class S>
Eigen::MatrixXd dense_matrix(const S& scene) {
  const Eigen::MatrixXd J = dense_jacobian(scene);
  return J * dense_inverse_mass(scene.bodies()).asDiagonal() * J.transpose();
}

/// How many rows of a matrix say something of their own: singular values above 1e-9 of the largest.
int rank(const Eigen::MatrixXd& matrix);

/// The least eigenvalue of a symmetric matrix.
double least_eigenvalue(const Eigen::MatrixXd& matrix);

}  // namespace byhand::joints
