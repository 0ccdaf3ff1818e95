#include "solver/gauss_seidel.hpp"

namespace byhand {
namespace {

template <int K>
Eigen::Matrix<double, K, K> inverse_of(Eigen::Matrix<double, K, K> A, BlockSolve block_solve) {
  if (block_solve == BlockSolve::whole || K == 1) return inverse_or_zero<K>(A);
  // Forward substitution on each unit vector: row k sees what the rows before it have already changed.
  Eigen::Matrix<double, K, K> E = Eigen::Matrix<double, K, K>::Zero();
  for (int k = 0; k < K; ++k)
    for (int j = 0; j <= k && A(k, k) > 0; ++j) {
      double left = k == j ? 1 : 0;
      for (int i = j; i < k; ++i) left -= A(k, i) * E(i, j);
      E(k, j) = left / A(k, k);
    }
  return E;
}

/// E of friction in space: the inverse of A's largest eigenvalue, for both tangents. On the rim of its disc λ
/// converges to the direction of -E JV, which opposes the slip only if E is a multiple of the identity.
Eigen::Matrix2d isotropic_inverse_of(const Eigen::Matrix2d& A) {
  const double mean = 0.5 * (A(0, 0) + A(1, 1)), half = 0.5 * (A(0, 0) - A(1, 1));
  const double largest = mean + std::sqrt(half * half + A(0, 1) * A(0, 1));
  return Eigen::Matrix2d::Identity() * (largest > 0 ? 1 / largest : 0.0);
}

template <class M, int K, Bound B>
void prepare(const Block<M, K, B>& block, const System<M>& system, BlockSolve block_solve, double relaxation,
             PreparedBlock<M, K, B>& result) {
  const double *gamma = &system.gamma[block.row], *bias = &system.bias[block.row];
  Eigen::Matrix<double, K, K> A = inverse_effective_mass(block.J, block.W), minus_E;
  for (int k = 0; k < K; ++k) A(k, k) += gamma[k];
  if constexpr (K == 2 && B == Bound::friction)
    minus_E = -relaxation * isotropic_inverse_of(A);
  else
    minus_E = -relaxation * inverse_of<K>(A, block_solve);
  result.normal_row = block.normal_row;
  result.J.noalias() = minus_E * block.J.matrix;
  result.bias.setZero();
  for (int k = 0; k < K; ++k)
    for (int l = 0; l < K; ++l) {
      result.bias[k] += minus_E(k, l) * bias[l];
      result.gamma[k][l] = minus_E(k, l) * gamma[l];
    }
  result.lower = system.lower[block.row];
  result.upper = system.upper[block.row];
}

void prepare(const Block<PlaneBody, 3, Bound::manifold>& block, const System<PlaneBody>& system,
             BlockSolve block_solve, double relaxation, PreparedBlock<PlaneBody, 3, Bound::manifold>& result) {
  Eigen::Matrix3d A = inverse_effective_mass(block.J, block.W);
  result.J = block.J.matrix;
  for (int k = 0; k < 3; ++k) {
    result.bias[k] = system.bias[block.row + k];
    result.gamma[k] = system.gamma[block.row + k];
    A(k, k) += result.gamma[k];
  }
  result.normals = {A, block_solve == BlockSolve::row_by_row};
  result.A02 = A(0, 2);
  result.A12 = A(1, 2);
  result.E22 = A(2, 2) > 0 ? 1 / A(2, 2) : 0.0;
  result.coefficient = system.upper[block.row];
  result.relaxation = relaxation;
}

//! [sweep]
/// The inner loop: (17), then (20), block after block. Not inlined, so that the compiler sees bare pointers.
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

}  // namespace

template <class M>
void prepare(const System<M>& system, BlockSolve block_solve, double relaxation, Prepared<M>& prepared) {
  prepared.soft = std::any_of(system.gamma.begin(), system.gamma.end(), [](double gamma) { return gamma != 0; });
  for_each_block_with(system, prepared.blocks, [&](const auto& block, auto& result) {
    result.body1 = block.body1;
    result.body2 = block.body2;
    result.moves1 = block.moves1;
    result.moves2 = block.moves2;
    result.row = block.row;
    result.W = block.W;
    prepare(block, system, block_solve, relaxation, result);
  });
}

template <class M>
void apply_all(const System<M>& system, const std::vector<double>& lambda, std::vector<Velocity<M>>& velocities) {
  double* V = numbers<M>(velocities);
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const Rows<K> change = Eigen::Map<const Rows<K>>(&lambda[block.row]);
      apply<M, K>(block, change, V);
    }
  });
}

template <class M>
void rates_of(const System<M>& system, const std::vector<Velocity<M>>& V, std::vector<double>& rates) {
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const Rows<K> rate = dot(block.J, V[block.body1], V[block.body2]);
      for (int k = 0; k < K; ++k) rates[block.row + k] = rate[k];
    }
  });
}

template <class M>
void multiply(const System<M>& system, const std::vector<double>& x, std::vector<Velocity<M>>& V,
              std::vector<double>& product) {
  std::fill(V.begin(), V.end(), Velocity<M>::Zero());
  apply_all(system, x, V);
  rates_of(system, V, product);
  for (int i = 0; i < system.rows(); ++i) product[i] += system.gamma[i] * x[i];
}

template <class M>
void hold_within_bounds(const System<M>& system, std::vector<double>& lambda) {
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    if constexpr (B != Bound::none)
      for (const auto& block : blocks) {
        Eigen::Map<Rows<K>> held(&lambda[block.row]);
        held = bounded<K, B>(held, system.lower[block.row], system.upper[block.row], lambda[block.normal_row]);
      }
  });
}

void require_valid(const GaussSeidel& solver) {
  require(solver.sweeps >= 1, "number of sweeps", solver.sweeps, "at least 1");
  require_inside("relaxation", solver.relaxation, 0, 2);
  require_in("tolerance", solver.tolerance, 0, 1e300, "m/s");
}

template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways) {
  const auto over = [&](const Run& run, bool back) {
    for_type<M>(run.type, [&](auto type) {
      const auto blocks = part<type>(prepared.blocks, run);
      const auto* first = back ? &blocks.back() : &blocks.front();
      const int next = back ? -1 : 1;
      if (prepared.soft)
        sweep_run<true>(first, run.count, next, lambda, V);
      else
        sweep_run<false>(first, run.count, next, lambda, V);
    });
  };
  for (const Run& run : system.runs) over(run, false);
  if (ways == 1) return;
  for (auto run = system.runs.rbegin(); run != system.runs.rend(); ++run) over(*run, true);
}

template <class M>
double watched_sweep(System<M>& system, Prepared<M>& prepared, std::vector<Velocity<M>>& velocities, int ways) {
  prepared.V_before = velocities;
  sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), ways);
  return largest_difference<M>(velocities, prepared.V_before);
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

#define BYHAND_INSTANTIATE(M)                                                                       \
  template void prepare(const System<M>&, BlockSolve, double, Prepared<M>&);                        \
  template void apply_all(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&); \
  template void rates_of(const System<M>&, const std::vector<Velocity<M>>&, std::vector<double>&);  \
  template void multiply(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&,   \
                         std::vector<double>&);                                                     \
  template void hold_within_bounds(const System<M>&, std::vector<double>&);                         \
  template void sweep(const System<M>&, const Prepared<M>&, double*, double*, int);                 \
  template double watched_sweep(System<M>&, Prepared<M>&, std::vector<Velocity<M>>&, int);          \
  template int solve(const GaussSeidel&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
