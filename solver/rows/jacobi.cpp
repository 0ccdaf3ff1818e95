#include "solver/rows/jacobi.hpp"

#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/prepared.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

template <bool soft, class M, int K, Bound B>
void find_change(const PreparedBlock<M, K, B>& block, const double* V, const double* lambda, double* changes) {
  Eigen::Map<Rows<K>>(changes + block.row) = solve<soft>(block, V, lambda);
}
template <bool soft>
void find_change(const PreparedManifold& block, const double* V, const double* lambda, double* changes) {
  with_numbers(block, [&]<class Number>(const ManifoldNumbers<Number>& numbers) {
    Number v1[3], v2[3], now[3];
    gather_velocities(block, V, v1, v2);
    gather(lambda, block.row, now);
    const auto change = solve<soft>(numbers, block.normals, v1, v2, now);
    for (int i = 0; i < lanes<Number>; ++i)
      for (int k = 0; k < 3; ++k) changes[block.row[i] + k] = lane(change[k], i);
  });
}

template <class M, int K, Bound B>
void apply_change(const PreparedBlock<M, K, B>& block, const double* changes, double* V) {
  apply<M, K>(block, Rows<K>(Eigen::Map<const Rows<K>>(changes + block.row)), V);
}
inline void apply_change(const PreparedManifold& block, const double* changes, double* V) {
  with_numbers(block, [&]<class Number>(const ManifoldNumbers<Number>& numbers) {
    Number v1[3], v2[3];
    std::array<Number, 3> change;
    gather_velocities(block, V, v1, v2);
    gather(changes, block.row, change.data());
    apply(numbers, change, v1, v2);
    scatter_velocities(block, v1, v2, V);
  });
}

template <bool soft, class M>
void sweep(System<M>& system, Prepared<M>& prepared, double* V) {
  double *lambda = system.lambda.data(), *changes = prepared.change.data();
  const auto for_each_prepared = [&](auto&& f) {
    for_each_block_with(system, prepared.blocks, [&](const auto&, const auto& block) { f(block); });
  };
  for_each_prepared([&](const auto& block) { find_change<soft>(block, V, lambda, changes); });
  for_each_prepared([&](const auto& block) { apply_change(block, changes, V); });
  for (int i = 0; i < system.rows(); ++i) lambda[i] += changes[i];
}

}  // namespace

template <class M>
Solution Jacobi::solve(System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, Begin begin) const {
  prepare(system, block_solve, relaxation, prepared);
  prepared.change.resize(system.rows());
  begin_sweeps(system, warm_start, begin, bodies);
  double* V = numbers<M>(bodies.velocity);
  for (int i = 0; i < sweeps; ++i)
    prepared.soft ? sweep<true>(system, prepared, V) : sweep<false>(system, prepared, V);
  return {sweeps, 0, std::numeric_limits<double>::quiet_NaN(), false};
}

#define BYHAND_INSTANTIATE(M) template Solution Jacobi::solve(System<M>&, Bodies<M>&, Prepared<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
