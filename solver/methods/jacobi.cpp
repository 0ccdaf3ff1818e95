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
void solve(const Jacobi& solver, System<M>& system, std::vector<Velocity<M>>& velocities, JacobiWork<M>& work,
           Begin begin) {
  prepare(system, solver.block_solve, solver.relaxation, work.prepared);
  work.change.resize(system.rows());
  begin_sweeps(system, solver.warm_start, begin, velocities);
  for (int i = 0; i < solver.sweeps; ++i) {
    if (work.prepared.soft)
      sweep<true>(system, work.prepared, work.change, numbers<M>(velocities));
    else
      sweep<false>(system, work.prepared, work.change, numbers<M>(velocities));
  }
}

#define BYHAND_INSTANTIATE(M) \
  template void solve(const Jacobi&, System<M>&, std::vector<Velocity<M>>&, JacobiWork<M>&, Begin)
BYHAND_INSTANTIATE(PlaneParticle);
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceParticle);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
