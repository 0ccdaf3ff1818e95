#pragma once

#include <optional>

#include "solver/direct/equations.hpp"

// Rows that cannot all be met: a rod between anchors that are too far apart, a triangle of rods that has none.
// They become dependent, or nearly so, and an exact solve answers what they ask for, b of their cure and of their
// target rates and J V of fixed bodies that have a velocity, with speeds that grow without limit, step after step.
namespace byhand {

/// γ of damped rows, as a share of their diagonal of A.
constexpr double damping = 0.04;

/// Answers what they ask for, c, by damped least squares, (A + 0.04 diag A)λ = -c, if the exact answer would make
/// some body more than 2.5 times as fast as all rows together ask one by one. Damped, it has at most 6.25 times
/// the energy that the rows would need one by one, whatever the units. Connected parts count and change only where
/// their rows are nearly dependent. `system.lambda` is the last `solve_equations`' and not yet applied; returns
/// whether it was changed, nothing where no part was suspected. What else the rows do stays exact.
///
/// Source: Y. Nakamura, H. Hanafusa, Inverse Kinematic Solutions With Singularity Robustness, J. Dyn. Sys., Meas.,
/// Control 108 (1986).
template <class M>
std::optional<bool> limit_correction(const Direct& solver, System<M>& system, const Bodies<M>& bodies,
                                     DirectWork<M>& work);

/// How fast a change of velocity makes a body [m/s], with turning at its radius of gyration.
template <class M>
double speed(const Bodies<M>& bodies, int body, const Velocity<M>& V) {
  double squares = V.template head<M::linear>().squaredNorm();
  if constexpr (M::angular > 0) {
    const InverseMass<M>& inverse = bodies.inverse_mass[body];
    const Angular<M> w = V.template tail<M::angular>();
    if (w.squaredNorm() > 0) squares += inverse.linear * w.dot(inertia(inverse, bodies.pose[body]) * w);
  }
  return std::sqrt(squares);
}

/// J of the bodies of a block that do not move, times their velocities.
template <class M, int K, Bound B>
Rows<K> led(const Bodies<M>& bodies, const Block<M, K, B>& block) {
  const auto of_fixed = [&](int body, bool moves) {
    return moves ? Velocity<M>(Velocity<M>::Zero()) : bodies.velocity[body];
  };
  return dot(block.J, of_fixed(block.body1, block.moves1), of_fixed(block.body2, block.moves2));
}

/// How fast row k of a block asks for by itself, by `rate` [1/s of its C]: the point that it holds, or a body that
/// has to be faster; or, of a row that only turns, a body that it turns about a point, `reach` [m] from it [m/s].
template <class M, int K, Bound B>
double asked_speed(const Bodies<M>& bodies, const Block<M, K, B>& block, int k, double rate, double reach = 0) {
  const double own = inverse_effective_mass(block.J, block.W, k);
  double most = 0;
  const auto ask = [&](int body, const auto& J, const auto& W) {
    const Velocity<M> V = std::abs(rate) / own * W.transpose();
    const double arm = J.template head<M::linear>().norm();
    const double own_speed = speed(bodies, body, V);
    most = std::max(
        {most, own_speed,
         arm > 0 ? std::abs(rate) / arm : std::hypot(own_speed, reach * V.template tail<M::angular>().norm())});
  };
  if (own <= 0) return 0;
  if (block.moves1) ask(block.body1, block.J.side1().row(k), block.W.side1().row(k));
  if (block.moves2) ask(block.body2, block.J.side2().row(k), block.W.side2().row(k));
  return most;
}

}  // namespace byhand
