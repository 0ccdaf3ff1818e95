#include "solver/methods/gauss_seidel.hpp"

namespace byhand {
namespace {

//! [sweep]
/// The inner loop: (17), then (20), block after block. Kept out of line so that the compiler sees bare
/// pointers.
template <bool soft, class M, int K, Bound B>
[[gnu::noinline]] void sweep_run(const PreparedBlock<M, K, B>* block, int count, int next, double* lambda,
                                 double* V) {
  for (; count > 0; --count, block += next) {
    const Rows<K> change = solve<soft>(*block, V, lambda);
    for (int k = 0; k < K; ++k) lambda[block->row + k] += change[k];
    apply<M, K>(*block, change, V);
  }
}
//! [sweep]

/// Sweeps over one run, back from its last block if so.
template <class M>
void sweep_run(const Run& run, const Prepared<M>& prepared, bool back, double* lambda, double* V) {
  for_type<M>(run.type, [&](auto type) {
    const auto blocks = part<type>(prepared.blocks, run);
    const auto* first = back ? blocks.data() + run.count - 1 : blocks.data();
    const int next = back ? -1 : 1;
    if (prepared.soft)
      sweep_run<true>(first, run.count, next, lambda, V);
    else
      sweep_run<false>(first, run.count, next, lambda, V);
  });
}

}  // namespace

void require_valid(const GaussSeidel& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
  require_in("tolerance", solver.tolerance, 0, 1e300, "m/s");
}

template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways) {
  for (const Run& run : system.runs) sweep_run(run, prepared, false, lambda, V);
  if (ways == 1) return;
  for (auto run = system.runs.rbegin(); run != system.runs.rend(); ++run)
    sweep_run(*run, prepared, true, lambda, V);
}

template <class M>
double watched_sweep(System<M>& system, Prepared<M>& prepared, std::vector<Velocity<M>>& velocities, int ways) {
  prepared.before = velocities;
  sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), ways);
  double largest = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i)
    largest = std::max(largest, (velocities[i] - prepared.before[i]).cwiseAbs().maxCoeff());
  return largest;
}

template <class M>
int solve(const GaussSeidel& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          Prepared<M>& prepared, Begin begin) {
  prepare(system, solver.block_solve, solver.relaxation, prepared);
  begin_sweeps(system, solver.warm_start, begin, velocities);
  const int ways = byhand::ways(solver.order);
  for (int i = 1; i <= solver.sweeps; ++i) {
    if (solver.tolerance == 0)
      sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), ways);
    else if (watched_sweep(system, prepared, velocities, ways) <= solver.tolerance)
      return ways * i;
  }
  return ways * solver.sweeps;
}

#define BYHAND_INSTANTIATE(M)                                                              \
  template void sweep(const System<M>&, const Prepared<M>&, double*, double*, int);        \
  template double watched_sweep(System<M>&, Prepared<M>&, std::vector<Velocity<M>>&, int); \
  template int solve(const GaussSeidel&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
