#include "solver/rows/gauss_seidel.hpp"

#include "solver/rows/operators.hpp"
#include "solver/rows/prepared.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

using detail::Pair;

/// Sweeps that watch nothing.
struct Unwatched {
  void rows(int, const auto&, const auto&) const {}
  void operator()(const int*, int, double, double) const {}
  void operator()(const int*, int, Pair, Pair) const {}
};

/// The largest squares of Δλ and λ, as speeds. The sum shows NaN, which the maxima pass over.
class Watch {
 public:
  explicit Watch(const double* speed) : speed_(speed) {}

  /// All rows of one block, two at a time.
  template <class Rows>
  void rows(int row, const Rows& delta, const auto& lambda) {
    constexpr int K = Rows::SizeAtCompileTime, last = K - 1;
    for (int k = 0; k + 1 < K; k += 2)
      note(Pair{speed_[row + k], speed_[row + k + 1]}, Pair{delta[k], delta[k + 1]},
           Pair{lambda[k], lambda[k + 1]});
    if constexpr (K % 2 == 1) (*this)(&row, last, delta[last], lambda[last]);
  }
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
            std::sqrt(std::max(largest_lambda_[0], largest_lambda_[1]))};
  }

 private:
  void note(Pair speed, Pair delta, Pair lambda) {
    const Pair square = speed * delta * delta, impulse = speed * lambda * lambda;
    change_ = change_ < square ? square : change_;
    sum_ += square;
    largest_lambda_ = largest_lambda_ < impulse ? impulse : largest_lambda_;
  }

  const double* speed_;  // of Prepared
  Pair change_ = {}, largest_lambda_ = {}, sum_ = {};
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
    watch.rows(block->row, change, now);
    apply<M, K>(*block, change, V);
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
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int passes,
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
  if (passes == 1) return;
  for (auto run = system.runs.rbegin(); run != system.runs.rend(); ++run) over(*run, true);
}

}  // namespace

template <class M>
void begin_sweeps(System<M>& system, bool warm_start, Begin begin, Bodies<M>& bodies) {
  if (begin == Begin::resume) return;
  if (warm_start)
    apply_all(system, system.lambda, bodies.velocity);
  else
    std::fill(system.lambda.begin(), system.lambda.end(), 0.0);
}

template <class M>
void sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V, int passes) {
  sweep(system, prepared, lambda, V, passes, Unwatched());
}

template <class M>
Residual watched_sweep(const System<M>& system, const Prepared<M>& prepared, double* lambda, double* V,
                       int passes) {
  Watch watch(prepared.speed.data());
  sweep(system, prepared, lambda, V, passes, watch);
  return watch.residual();
}

template <class M>
Solution sweep_until(double tolerance, int most, int passes, System<M>& system, const Prepared<M>& prepared,
                     Bodies<M>& bodies) {
  Solution solution;
  const double speed = fastest(system, bodies.velocity);
  do {
    const Residual reached =
        watched_sweep(system, prepared, system.lambda.data(), numbers<M>(bodies.velocity), passes);
    solution = {solution.passes + passes, 0, reached.largest, reached.within(tolerance, speed)};
  } while (!solution.converged && solution.residual >= 0 && solution.passes < passes * most);
  return solution;
}

template <class M>
Solution GaussSeidel::solve(System<M>& system, Bodies<M>& bodies, Prepared<M>& prepared, Begin begin) const {
  prepare(system, block_solve, relaxation, prepared);
  begin_sweeps(system, warm_start, begin, bodies);
  const int passes = byhand::passes(order);
  if (tolerance > 0) {
    prepare_to_watch(system, relaxation, prepared);
    return sweep_until(tolerance, sweeps, passes, system, prepared, bodies);
  }
  for (int i = 0; i < sweeps; ++i)
    sweep(system, prepared, system.lambda.data(), numbers<M>(bodies.velocity), passes);
  return {passes * sweeps, 0, std::numeric_limits<double>::quiet_NaN(), false};
}

#define BYHAND_INSTANTIATE(M)                                                                   \
  template void begin_sweeps(System<M>&, bool, Begin, Bodies<M>&);                              \
  template void sweep(const System<M>&, const Prepared<M>&, double*, double*, int);             \
  template Residual watched_sweep(const System<M>&, const Prepared<M>&, double*, double*, int); \
  template Solution sweep_until(double, int, int, System<M>&, const Prepared<M>&, Bodies<M>&);  \
  template Solution GaussSeidel::solve(System<M>&, Bodies<M>&, Prepared<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
