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

/// Sweeps that watch nothing.
struct Unwatched {
  void operator()(int, double, double) const {}
};

/// The largest squares of Δλ and λ, as speeds. The sum shows NaN, which the maxima pass over.
struct Watch {
  const double* speed;  // of Prepared
  double change = 0, push = 0, sum = 0;

  void operator()(int row, double delta, double lambda) {
    const double square = speed[row] * delta * delta;
    change = std::max(change, square);
    sum += square;
    push = std::max(push, speed[row] * lambda * lambda);
  }
};

//! [sweep]
/// The inner loop: (17), then (20), block after block. Not inlined, so that the compiler sees bare pointers.
template <bool soft, class M, int K, Bound B, class Watching>
[[gnu::noinline]] void sweep_run(const PreparedBlock<M, K, B>* block, int count, int next, double* lambda,
                                 double* V, Watching& watch) {
  for (; count > 0; --count, block += next) {
    const Rows<K> change = solve<soft>(*block, V, lambda);
    Eigen::Map<Rows<K>> now(lambda + block->row);
    now += change;
    apply<M, K>(*block, change, V);
    for (int k = 0; k < K; ++k) watch(block->row + k, change[k], now[k]);
  }
}
//! [sweep]

template <class M, class Watching>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways,
           Watching&& watch) {
  const auto over = [&](const Run& run, bool back) {
    for_type<M>(run.type, [&](auto type) {
      const auto blocks = part<type>(prepared.blocks, run);
      const auto* first = back ? &blocks.back() : &blocks.front();
      const int next = back ? -1 : 1;
      if (prepared.soft)
        sweep_run<true>(first, run.count, next, lambda, V, watch);
      else
        sweep_run<false>(first, run.count, next, lambda, V, watch);
    });
  };
  for (const Run& run : system.runs) over(run, false);
  if (ways == 1) return;
  for (auto run = system.runs.rbegin(); run != system.runs.rend(); ++run) over(*run, true);
}

/// m₁⁻¹ + m₂⁻¹ of a block's bodies.
template <class M>
double inverse_mass(const System<M>& system, const BlockHeader& block) {
  return system.inverse_mass[block.body1].linear + system.inverse_mass[block.body2].linear;
}

}  // namespace

template <class M>
void prepare(const System<M>& system, BlockSolve block_solve, double relaxation, Prepared<M>& prepared) {
  prepared.soft = std::any_of(system.gamma.begin(), system.gamma.end(), [](double gamma) { return gamma != 0; });
  for_each_block_with(system, prepared.blocks, [&]<int K, Bound B>(const Block<M, K, B>& block, auto& result) {
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
void prepare_to_watch(const System<M>& system, double relaxation, Prepared<M>& prepared) {
  const double per_relaxation = 1 / (relaxation * relaxation);
  prepared.impulse.resize(system.rows());
  prepared.speed.resize(system.rows());
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const double share = inverse_mass(system, block), speed = share * per_relaxation;
      for (int k = 0, row = block.row; k < K; ++k, ++row) {
        const double D = inverse_effective_mass(block.J, block.W, k) + system.gamma[row];
        const double l2 = std::max(block.J.l1().row(k).squaredNorm(), block.J.l2().row(k).squaredNorm());
        prepared.impulse[row] = l2 > 0 || share == 0 ? l2 : D / share;
        prepared.speed[row] = D * speed;
      }
    }
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
void errors_of(const System<M>& system, const std::vector<Velocity<M>>& velocities,
               const std::vector<double>& lambda, std::vector<double>& error) {
  rates_of(system, velocities, error);
  for (int i = 0; i < system.rows(); ++i) error[i] += system.bias[i] + system.gamma[i] * lambda[i];
}

template <class M>
void find_scales(const System<M>& system, RowScales& scales) {
  scales.D.resize(system.rows());
  scales.speed.resize(system.rows());
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      double* D = &scales.D[block.row];
      for (int k = 0; k < K; ++k) D[k] = inverse_effective_mass(block.J, block.W, k) + system.gamma[block.row + k];
      if constexpr (K == 2 && B == Bound::friction) D[0] = D[1] = larger(D[0], D[1]);
      for (int k = 0; k < K; ++k) scales.speed[block.row + k] = std::sqrt(D[k] * inverse_mass(system, block));
    }
  });
}

template <class M>
Residual residual(const System<M>& system, const std::vector<double>& lambda, const std::vector<double>& error,
                  const RowScales& scales) {
  Residual result;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const int row = block.row;
      const Eigen::Map<const Rows<K>> now(&lambda[row]);
      Rows<K> next = now;
      for (int k = 0; k < K; ++k)
        if (scales.D[row + k] != 0) next[k] -= error[row + k] / scales.D[row + k];
      const double normal = B == Bound::friction ? lambda[block.normal_row] : 0.0;
      next = bounded<K, B>(next, system.lower[row], system.upper[row], normal);
      for (int k = 0; k < K; ++k) {
        result.largest = larger(result.largest, scales.speed[row + k] * std::abs(next[k] - now[k]));
        result.push = larger(result.push, scales.speed[row + k] * std::abs(now[k]));
      }
    }
  });
  return result;
}

template <class M>
double fastest(const System<M>& system, const std::vector<Velocity<M>>& velocities) {
  double square = 0;
  for (std::size_t i = 0; i < velocities.size(); ++i) {
    const InverseMass<M>& mass = system.inverse_mass[i];
    if (!moves(mass)) continue;
    double now = velocities[i].template head<M::linear>().squaredNorm();
    if constexpr (M::angular > 0)
      now += velocities[i].template tail<M::angular>().squaredNorm() * mass.linear / mass.angular.minCoeff();
    square = larger(square, now);
  }
  return std::sqrt(square);
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
  require_valid_tolerance(solver.tolerance);
}

template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways) {
  sweep(system, prepared, lambda, V, ways, Unwatched());
}

template <class M>
Residual watched_sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int ways) {
  Watch watch{prepared.speed.data()};
  sweep(system, prepared, lambda, V, ways, watch);
  return {std::sqrt(std::isnan(watch.sum) ? watch.sum : watch.change), std::sqrt(watch.push)};
}

template <class M>
Solution sweep_until(double tolerance, int most, int ways, System<M>& system, const Prepared<M>& prepared,
                     std::vector<Velocity<M>>& velocities) {
  Solution solution;
  const double speed = fastest(system, velocities);
  do {
    const Residual reached = watched_sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), ways);
    solution = {solution.passes + ways, 0, reached.largest, reached.within(tolerance, speed)};
  } while (!solution.converged && solution.residual >= 0 && solution.passes < ways * most);
  return solution;
}

template <class M>
Solution solve(const GaussSeidel& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
               Prepared<M>& prepared, Begin begin) {
  prepare(system, solver.block_solve, solver.relaxation, prepared);
  begin_sweeps(system, solver.warm_start, begin, velocities);
  const int ways = byhand::ways(solver.order);
  if (solver.tolerance > 0) {
    prepare_to_watch(system, solver.relaxation, prepared);
    return sweep_until(solver.tolerance, solver.sweeps, ways, system, prepared, velocities);
  }
  for (int i = 0; i < solver.sweeps; ++i)
    sweep(system, prepared, system.lambda.data(), numbers<M>(velocities), ways);
  return {ways * solver.sweeps, 0, std::numeric_limits<double>::quiet_NaN(), false};
}

#define BYHAND_INSTANTIATE(M)                                                                                 \
  template void prepare(const System<M>&, BlockSolve, double, Prepared<M>&);                                  \
  template void prepare_to_watch(const System<M>&, double, Prepared<M>&);                                     \
  template void apply_all(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&);           \
  template void rates_of(const System<M>&, const std::vector<Velocity<M>>&, std::vector<double>&);            \
  template void multiply(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&,             \
                         std::vector<double>&);                                                               \
  template void hold_within_bounds(const System<M>&, std::vector<double>&);                                   \
  template void sweep(const System<M>&, const Prepared<M>&, double*, double*, int);                           \
  template void errors_of(const System<M>&, const std::vector<Velocity<M>>&, const std::vector<double>&,      \
                          std::vector<double>&);                                                              \
  template void find_scales(const System<M>&, RowScales&);                                                    \
  template Residual residual(const System<M>&, const std::vector<double>&, const std::vector<double>&,        \
                             const RowScales&);                                                               \
  template double fastest(const System<M>&, const std::vector<Velocity<M>>&);                                 \
  template Residual watched_sweep(const System<M>&, const Prepared<M>&, double*, double*, int);               \
  template Solution sweep_until(double, int, int, System<M>&, const Prepared<M>&, std::vector<Velocity<M>>&); \
  template Solution solve(const GaussSeidel&, System<M>&, std::vector<Velocity<M>>&, Prepared<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
