#include "solver/rows/gauss_seidel.hpp"

namespace byhand {
namespace {

using detail::Pair;

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
             double* D, PreparedBlock<M, K, B>& result) {
  const double *gamma = &system.gamma[block.row], *bias = &system.bias[block.row];
  Eigen::Matrix<double, K, K> A = inverse_effective_mass(block.J, block.W), minus_E;
  for (int k = 0; k < K; ++k) D[block.row + k] = A(k, k) += gamma[k];
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

/// Writes a manifold into a lane of `result` and of its `numbers`.
template <class Number>
void prepare(const Block<PlaneBody, 3, Bound::manifold>& block, const System<PlaneBody>& system,
             BlockSolve block_solve, double relaxation, double* D, int lane, PreparedManifold& result,
             ManifoldNumbers<Number>& numbers) {
  const InverseMass<PlaneBody>&mass1 = system.inverse_mass[block.body1], &mass2 = system.inverse_mass[block.body2];
  const double m = mass1.linear + mass2.linear, I1 = mass1.angular[0], I2 = mass2.angular[0];
  const double *J = block.J.matrix.data(), *gamma = &system.gamma[block.row];
  // (19): the normals have one direction, at right angles to that of friction.
  const auto turning = [&](int k, int l) { return I1 * J[k + 2] * J[l + 2] + I2 * J[k + 5] * J[l + 5]; };
  const auto alike = [&](int k, int l) { return m * (J[k + 3] * J[l + 3] + J[k + 4] * J[l + 4]) + turning(k, l); };
  constexpr int rows[] = {0, 6, 12};
  const double A00 = alike(0, 0) + gamma[0], A11 = alike(6, 6) + gamma[1], A22 = alike(12, 12) + gamma[2];
  D[block.row] = A00;
  D[block.row + 1] = A11;
  D[block.row + 2] = A22;
  const NormalRows normals(A00, alike(0, 6), A11, block_solve == BlockSolve::row_by_row);
  result.count = lane + 1;
  result.row[lane] = block.row;
  result.body1[lane] = block.body1;
  result.body2[lane] = block.body2;
  result.moves1[lane] = block.moves1;
  result.moves2[lane] = block.moves2;
  result.normals[lane] = normals;
  const auto set = [&](Number& number, double value) { set_lane(number, lane, value); };
  set(numbers.nx, J[3]);
  set(numbers.ny, J[4]);
  set(numbers.ends, J[9] != 0 || J[10] != 0);
  set(numbers.m1, mass1.linear);
  set(numbers.I1, I1);
  set(numbers.m2, mass2.linear);
  set(numbers.I2, I2);
  for (int k = 0; k < 3; ++k) {
    set(numbers.a1[k], J[rows[k] + 2]);
    set(numbers.a2[k], J[rows[k] + 5]);
    set(numbers.bias[k], system.bias[block.row + k]);
    set(numbers.gamma[k], gamma[k]);
  }
  set(numbers.E00, normals.E00);
  set(numbers.E01, normals.E01);
  set(numbers.E11, normals.E11);
  set(numbers.A02, turning(0, 12));
  set(numbers.A12, turning(6, 12));
  set(numbers.E22, A22 > 0 ? 1 / A22 : 0.0);
  set(numbers.coefficient, system.upper[block.row]);
  set(numbers.relaxation, relaxation);
}

/// Whether two blocks share no body that moves.
bool apart(const BlockHeader& a, const BlockHeader& b) {
  const auto has = [&](int body) { return body == b.body1 || body == b.body2; };
  return !(a.moves1 && has(a.body1)) && !(a.moves2 && has(a.body2));
}

template <class M, int K, Bound B>
void prepare_run(std::span<const Block<M, K, B>> blocks, const System<M>& system, BlockSolve block_solve,
                 double relaxation, double* D, std::span<PreparedBlock<M, K, B>> results) {
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    const Block<M, K, B>& block = blocks[i];
    PreparedBlock<M, K, B>& result = results[i];
    result.body1 = block.body1;
    result.body2 = block.body2;
    result.moves1 = block.moves1;
    result.moves2 = block.moves2;
    result.row = block.row;
    result.W = block.W;
    prepare(block, system, block_solve, relaxation, D, result);
  }
}

/// Two manifolds in a result where they share no moving body.
void prepare_run(std::span<const Block<PlaneBody, 3, Bound::manifold>> blocks, const System<PlaneBody>& system,
                 BlockSolve block_solve, double relaxation, double* D, std::span<PreparedManifold> results) {
  std::size_t used = 0;
  for (std::size_t i = 0; i < blocks.size(); ++i) {
    PreparedManifold& result = results[used++];
    const auto write = [&](int lane, auto& numbers) {
      prepare(blocks[i + lane], system, block_solve, relaxation, D, lane, result, numbers);
    };
    if (i + 1 < blocks.size() && apart(blocks[i + 1], blocks[i])) {
      write(0, result.two);
      write(1, result.two);
      ++i;
    } else {
      write(0, result.one);
    }
  }
  for (; used < results.size(); ++used) results[used].count = 0;
}

/// Sweeps that watch nothing.
struct Unwatched {
  void operator()(const int*, int, double, double) const {}
  void operator()(const int*, int, Pair, Pair) const {}
};

/// The largest squares of Δλ and λ, as speeds. The sum shows NaN, which the maxima pass over.
class Watch {
 public:
  explicit Watch(const double* speed) : speed_(speed) {}

  /// Row k of one block, or of two, whose first rows are given.
  void operator()(const int* first, int k, double delta, double lambda) {
    note(Pair{speed_[first[0] + k], 0}, Pair{delta, 0}, Pair{lambda, 0});
  }
  void operator()(const int* first, int k, Pair delta, Pair lambda) {
    note(Pair{speed_[first[0] + k], speed_[first[1] + k]}, delta, lambda);
  }
  Residual residual() const {
    const double sum = sum_[0] + sum_[1];
    return {std::sqrt(std::isnan(sum) ? sum : std::max(change_[0], change_[1])),
            std::sqrt(std::max(push_[0], push_[1]))};
  }

 private:
  void note(Pair speed, Pair delta, Pair lambda) {
    const Pair square = speed * delta * delta, push = speed * lambda * lambda;
    change_ = change_ < square ? square : change_;
    sum_ += square;
    push_ = push_ < push ? push : push_;
  }

  const double* speed_;  // of Prepared
  Pair change_ = {}, push_ = {}, sum_ = {};
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
    for (int k = 0; k < K; ++k) watch(&block->row, k, change[k], now[k]);
  }
}
//! [sweep]

/// The same over manifolds, one or two at a time.
template <bool soft, class Watching>
[[gnu::noinline]] void sweep_run(const PreparedManifold* block, int count, int next, double* lambda, double* V,
                                 Watching& watch) {
  for (; count > 0; --count, block += next)
    with_numbers(*block, [&]<class Number>(const ManifoldNumbers<Number>& numbers) {
      Number v1[3], v2[3], now[3];
      gather_velocities(*block, V, v1, v2);
      gather(lambda, block->row, now);
      const auto change = solve<soft>(numbers, block->normals, v1, v2, now);
      apply(numbers, change, v1, v2);
      scatter_velocities(*block, v1, v2, V);
      for (int k = 0; k < 3; ++k) {
        now[k] += change[k];
        for (int i = 0; i < lanes<Number>; ++i) lambda[block->row[i] + k] = lane(now[k], i);
        watch(block->row, k, change[k], now[k]);
      }
    });
}

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
  prepared.D.resize(system.rows());
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      std::get<type>(prepared.blocks).resize(std::get<type>(system.blocks).size());
      prepare_run(part<type>(system.blocks, run), system, block_solve, relaxation, prepared.D.data(),
                  part<type>(prepared.blocks, run));
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
        const double D = prepared.D[row];
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
  Watch watch(prepared.speed.data());
  sweep(system, prepared, lambda, V, ways, watch);
  return watch.residual();
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
