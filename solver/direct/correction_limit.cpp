#include "solver/direct/correction_limit.hpp"

#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

constexpr double most_amplified = 2.5;  // 1 / (2 √damping)
constexpr double negligible = 0.01;     // of what else the rows do

/// Whether the rows' impulses together take so much more energy than one by one that near dependence may be why:
/// λᵀr against Σ r²/Aₖₖ, for λ = A⁻¹r. A chain's ratio grows with the square of its length, also if one row asks.
template <class M>
bool is_suspect(const System<M>& system, const DirectWork<M>& work) {
  double together = 0, apart = 0;
  for (const auto& node : work.plan.nodes)
    for (int k = 0; node.edge >= 0 && k < node.size; ++k) {
      const double r = work.right[node.lambda + k], A = work.diagonal[node.row + k];
      if (A > 0) together += r * system.lambda[node.lambda + k], apart += r * r / A;
    }
  return together > 4.0 * system.rows() * system.rows() * apart;
}

/// The largest speed that impulses give to a body.
template <class M>
double fastest(const System<M>& system, const Bodies<M>& bodies, const std::vector<double>& lambda,
               std::vector<Velocity<M>>& V) {
  V.assign(bodies.size(), Velocity<M>::Zero());
  apply_all(system, lambda, V);
  double result = 0;
  for (int body = 0; body < bodies.size(); ++body) result = std::max(result, speed(bodies, body, V[body]));
  return result;
}

/// The sum of the speeds that the rows ask for one by one.
template <class M>
double asked(const System<M>& system, const Bodies<M>& bodies, const std::vector<double>& correction) {
  double sum = 0;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    for (int k = 0; k < K; ++k) sum += asked_speed(bodies, block, k, correction[block.row + k]);
  });
  return sum;
}

}  // namespace

template <class M>
bool limit_correction(const Direct& solver, System<M>& system, const Bodies<M>& bodies, DirectWork<M>& work) {
  if (!is_suspect(system, work)) return false;
  std::vector<double>&correction = work.offset, &change = work.change;
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const Rows<K> rate = led(bodies, block);
    for (int k = 0; k < K; ++k) correction[block.row + k] = system.bias[block.row + k] + rate[k];
  });
  solve_again(correction, work, change);
  const double speeds = asked(system, bodies, correction);
  if (fastest(system, bodies, change, work.velocity_before) <= most_amplified * speeds) return false;
  std::vector<double>& rest = work.lambda_before = system.lambda;
  for (int k = 0; k < system.rows(); ++k) rest[k] -= change[k];
  if (speeds <= negligible * fastest(system, bodies, rest, work.velocity_before)) return false;
  Direct damped = solver;
  damped.regularisation = std::max(solver.regularisation, damping);
  solve_equations(damped, system, correction, bodies, work, change);
  solve_again(correction, work, change);
  for (int k = 0; k < system.rows(); ++k) system.lambda[k] = rest[k] + change[k];
  return true;
}

#define BYHAND_INSTANTIATE(M) \
  template bool limit_correction(const Direct&, System<M>&, const Bodies<M>&, DirectWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
