#include "solver/methods/jacobi.hpp"

namespace byhand {
namespace {

template <class M, class F>
void for_each_block(const System<M>& system, const Prepared<M>& prepared, F&& f) {
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (const auto& block : part<type>(prepared.blocks, run)) f(block);
    });
}

template <bool soft, class M>
void sweep(System<M>& system, const Prepared<M>& prepared, std::vector<double>& change, double* V) {
  for_each_block(system, prepared, [&]<int K, Bound B>(const PreparedBlock<M, K, B>& block) {
    Eigen::Map<Rows<K>>(change.data() + block.row) = solve<soft>(block, V, system.lambda.data());
  });
  for_each_block(system, prepared, [&]<int K, Bound B>(const PreparedBlock<M, K, B>& block) {
    const Rows<K> by = Eigen::Map<const Rows<K>>(change.data() + block.row);
    Eigen::Map<Rows<K>>(system.lambda.data() + block.row) += by;
    apply<M, K>(block, by, V);
  });
}

}  // namespace

void require_valid(const Jacobi& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
}

template <class M>
int solve(const Jacobi& solver, System<M>& system, std::vector<Velocity<M>>& velocities, Prepared<M>& prepared,
          std::vector<double>& change, Begin begin) {
  prepare(system, solver.block_solve, solver.relaxation, prepared);
  change.resize(system.rows());
  begin_sweeps(system, solver.warm_start, begin, velocities);
  for (int i = 0; i < solver.sweeps; ++i) {
    if (prepared.soft)
      sweep<true>(system, prepared, change, numbers<M>(velocities));
    else
      sweep<false>(system, prepared, change, numbers<M>(velocities));
  }
  return solver.sweeps;
}

#define BYHAND_INSTANTIATE(M)                                                                                  \
  template int solve(const Jacobi&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, std::vector<double>&, \
                     Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
