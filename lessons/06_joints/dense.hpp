#pragma once

#include <Eigen/Core>

#include "lessons/06_joints/setting.hpp"

// A scene's rows as a textbook writes them, as dense matrices: what the lesson counts and looks at.
namespace byhand::joints {

/// J of all rows over all bodies, fixed ones left out, as the scene now stands.
Eigen::MatrixXd dense_jacobian(const Scene<PlaneBody>& scene);

/// A = JM⁻¹Jᵀ of all rows.
Eigen::MatrixXd dense_matrix(const Scene<PlaneBody>& scene);

/// How many rows of a matrix say something of their own: pivots of QR above 1e-9 of the largest.
int rank(const Eigen::MatrixXd& matrix);

/// The least eigenvalue of a symmetric matrix.
double least_eigenvalue(const Eigen::MatrixXd& matrix);

}  // namespace byhand::joints
