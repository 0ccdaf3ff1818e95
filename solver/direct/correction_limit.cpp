#include "solver/direct/correction_limit.hpp"

#include <algorithm>

#include "solver/rows/operators.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

constexpr double most_amplified = 2.5;  // 1 / (2 √damping)
constexpr double negligible = 0.01;     // of what else the rows do

/// Whether the impulses of some part's rows together take so much more energy than one by one that near dependence
/// may be why: λᵀr against Σ r²/Aₖₖ, for λ = A⁻¹r. A chain's ratio grows with the square of its length, also if
/// one row asks.
template <class M>
bool find_suspects(const System<M>& system, DirectWork<M>& work) {
  work.parts.assign(work.plan.nodes.size(), {});
  for (const auto& node : work.plan.nodes) {
    ConnectedPart& part = work.parts[node.root];
    for (int k = 0; node.edge >= 0 && k < node.size; ++k, ++part.rows) {
      const double r = work.right[node.lambda + k], A = work.diagonal[node.row + k];
      if (A > 0) part.together += r * system.lambda[node.lambda + k], part.apart += r * r / A;
    }
  }
  return std::ranges::any_of(work.parts, &ConnectedPart::suspect);
}

/// f(row) of the suspects.
template <class M>
void for_each_suspect(const DirectWork<M>& work, auto&& f) {
  for (const auto& node : work.plan.nodes)
    for (int k = 0; work.parts[node.root].suspect() && node.edge >= 0 && k < node.size; ++k) f(node.lambda + k);
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

}  // namespace

template <class M>
std::optional<bool> limit_correction(const Direct& solver, System<M>& system, const Bodies<M>& bodies,
                                     DirectWork<M>& work) {
  if (!find_suspects(system, work)) return std::nullopt;
  std::vector<double>&correction = work.offset, &change = work.change, &rest = work.lambda_before;
  correction.assign(system.rows(), 0.0);
  for_each_suspect(work, [&](int row) { correction[row] = 1; });
  double speeds = 0;  // that the rows ask for one by one
  for_each_block(system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    const Rows<K> rate = led(bodies, block);
    for (int k = 0, row = block.row; k < K; ++k, ++row) {
      correction[row] *= system.bias[row] + rate[k];
      speeds += asked_speed(bodies, block, k, correction[row]);
    }
  });
  solve_again(correction, work, change);
  if (fastest(system, bodies, change, work.velocity_before) <= most_amplified * speeds) return false;
  rest.assign(system.rows(), 0.0);
  for_each_suspect(work, [&](int row) { rest[row] = system.lambda[row] - change[row]; });
  if (speeds <= negligible * fastest(system, bodies, rest, work.velocity_before)) return false;
  Direct damped = solver;
  damped.regularisation = std::max(solver.regularisation, damping);
  solve_equations(damped, system, correction, bodies, work, change);
  solve_again(correction, work, change);
  for_each_suspect(work, [&](int row) { system.lambda[row] = rest[row] + change[row]; });
  return true;
}

#define BYHAND_INSTANTIATE(M) \
  template std::optional<bool> limit_correction(const Direct&, System<M>&, const Bodies<M>&, DirectWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
