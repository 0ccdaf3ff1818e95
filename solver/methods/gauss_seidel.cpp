#include "solver/methods/gauss_seidel.hpp"

namespace byhand {
namespace {

//! [sweep]
/// The inner loop: (17), then (20), block after block. Kept out of line so that the compiler sees bare
/// pointers.
template <bool soft, class M, int K, Bound B>
[[gnu::noinline]] void sweep_run(const PreparedBlock<M, K, B>* block, const PreparedBlock<M, K, B>* end,
                                 double* lambda, double* V) {
  for (; block != end; ++block) {
    const Rows<K> change = solve<soft>(*block, V, lambda);
    for (int k = 0; k < K; ++k) lambda[block->row + k] += change[k];
    apply<M, K>(*block, change, V);
  }
}
//! [sweep]

}  // namespace

void require_valid(const GaussSeidel& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
}

template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V) {
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      const auto blocks = part<type>(prepared.blocks, run);
      const auto *first = blocks.data(), *end = first + blocks.size();
      if (prepared.soft)
        sweep_run<true>(first, end, lambda, V);
      else
        sweep_run<false>(first, end, lambda, V);
    });
}

template <class M>
void solve(const GaussSeidel& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
           Prepared<M>& prepared) {
  prepare(system, solver.block_solve, solver.relaxation, prepared);
  if (solver.warm_start)
    apply_all(system, velocities);
  else
    std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
  for (int i = 0; i < solver.sweeps; ++i) sweep(system, prepared, system.lambda.data(), numbers<M>(velocities));
}

#define BYHAND_INSTANTIATE(M)                                                  \
  template void sweep(const System<M>&, const Prepared<M>&, double*, double*); \
  template void solve(const GaussSeidel&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&)
BYHAND_INSTANTIATE(PlaneParticle);
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceParticle);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
