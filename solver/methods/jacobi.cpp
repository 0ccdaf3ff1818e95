#include "solver/methods/jacobi.hpp"

namespace byhand {
namespace {

template <bool soft, class M>
void sweep(System<M>& system, Prepared<M>& prepared, double* V) {
  double *lambda = system.lambda.data(), *changes = prepared.change.data();
  for_each_block_with(system, prepared.blocks,
                      [&]<int K, Bound B>(const auto&, const PreparedBlock<M, K, B>& block) {
                        Eigen::Map<Rows<K>>(changes + block.row) = solve<soft>(block, V, lambda);
                      });
  for_each_block_with(system, prepared.blocks,
                      [&]<int K, Bound B>(const auto&, const PreparedBlock<M, K, B>& block) {
                        const Rows<K> change = Eigen::Map<const Rows<K>>(changes + block.row);
                        Eigen::Map<Rows<K>>(lambda + block.row) += change;
                        apply<M, K>(block, change, V);
                      });
}

}  // namespace

void require_valid(const Jacobi& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
}

template <class M>
Solution solve(const Jacobi& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
               Prepared<M>& prepared, Begin begin) {
  prepare(system, solver.block_solve, solver.relaxation, prepared);
  prepared.change.resize(system.rows());
  begin_sweeps(system, solver.warm_start, begin, velocities);
  for (int i = 0; i < solver.sweeps; ++i)
    prepared.soft ? sweep<true>(system, prepared, numbers<M>(velocities))
                  : sweep<false>(system, prepared, numbers<M>(velocities));
  return {solver.sweeps, 0, std::numeric_limits<double>::quiet_NaN(), false};
}

#define BYHAND_INSTANTIATE(M) \
  template Solution solve(const Jacobi&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
