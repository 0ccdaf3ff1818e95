#pragma once

#include "lessons/methods/accelerated_gradient.hpp"
#include "lessons/methods/conjugate_gradients.hpp"
#include "solver/step.hpp"

namespace byhand {

/// The row solvers of the library and those that compete with them.
using AnyRowSolver = std::variant<GaussSeidel, Jacobi, Direct, ConjugateSweeps, SemismoothNewton, ByGraph,
                                  ConjugateGradients, AcceleratedGradient>;
using AnyStepping = VelocitySteppingWith<AnyRowSolver, DriftCure>;

}  // namespace byhand
