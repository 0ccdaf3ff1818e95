#pragma once

#include <Eigen/Core>

#include "lessons/03_iterations/knobs.hpp"
#include "lessons/scenes/chain.hpp"

// The hanging chain as a textbook writes it, from its masses alone: dense matrices that the lesson's measurements
// are held against. Rows are taken per metre (J = n), so errors are rates of stretch [m/s].
namespace byhand::iterations {

/// JM⁻¹Jᵀ [1/kg]: a joint meets its neighbours through the bobs that they share.
Eigen::MatrixXd textbook_matrix(const ChainOptions& chain);

/// What one Gauss–Seidel sweep from the top does to the errors: I - A(D + L)⁻¹, with D the diagonal of A and L
/// what is below it.
Eigen::MatrixXd textbook_sweep(const Eigen::MatrixXd& A);

/// The factor by which a sweep of Jacobi's shrinks errors in the long run: the largest |1 - μ| over the
/// eigenvalues μ of D⁻¹A, for a symmetric A. Gauss–Seidel's is its square on a chain.
double textbook_jacobi_factor(const Eigen::MatrixXd& A);

/// The errors that each step is left with when it begins at λ = 0 and has `sweeps` sweeps, once that has settled;
/// gravity adds `fall` [m/s] to the first row's error in each step.
Eigen::VectorXd textbook_cold_errors(const ChainOptions& chain, int sweeps, double fall);

/// How many sweeps take one decimal digit off the error.
double sweeps_per_digit(double factor);

}  // namespace byhand::iterations
