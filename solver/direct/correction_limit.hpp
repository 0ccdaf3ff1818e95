#pragma once

#include "solver/direct/equations.hpp"

// Rows that cannot all be met: a rod between anchors that are too far apart, a triangle of rods that has none.
// They become dependent, or nearly so, and an exact solve answers the correction c = b - target rate that their
// cure asks for with speeds that grow without limit, step after step.
namespace byhand {

/// Corrects by damped least squares, (A + 0.04 diag A)λ = -c, if the exact correction would make some body more
/// than 2.5 times as fast as all rows together ask one by one. Damped, the correction has at most 6.25 times the
/// energy that the rows would need one by one, whatever the units. `system.lambda` is the last `solve_equations`'
/// and not yet applied; returns whether it was changed. What else the rows do stays exact.
///
/// Source: Y. Nakamura, H. Hanafusa, Inverse Kinematic Solutions With Singularity Robustness, J. Dyn. Sys., Meas.,
/// Control 108 (1986).
template <class M>
bool limit_correction(const Direct& solver, System<M>& system, const Bodies<M>& bodies, DirectWork<M>& work);

}  // namespace byhand
