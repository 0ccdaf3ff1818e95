#include "solver/methods/conjugate_gradients.hpp"

#include <cmath>

namespace byhand {
namespace {

// Of r·z beside what it was at first: once r is rounding, the directions that it gives lead anywhere.
constexpr double rounding = 1e-30;

/// E of each block; there are none with bounds.
template <class M>
void invert_blocks(const System<M>& system, ConjugateGradientWork<M>& work) {
  system.for_each_type([&]<int K, Bound B>(const std::vector<Block<M, K, B>>& blocks) {
    if constexpr (B == Bound::none) {
      auto& inverses = std::get<block_type<M, K, B>()>(work.inverses);
      inverses.resize(blocks.size());
      for (std::size_t i = 0; i < blocks.size(); ++i) {
        auto A = inverse_effective_mass(blocks[i].J, blocks[i].W);
        for (int k = 0; k < K; ++k) A(k, k) += system.gamma[blocks[i].row + k];
        inverses[i] = inverse_or_zero<K>(A);
      }
    }
  });
}

/// z = E r.
template <class M>
void precondition(const System<M>& system, ConjugateGradientWork<M>& work) {
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      const auto inverses = part<type>(work.inverses, run);
      int row = run.row;
      for (const auto& E : inverses) {
        constexpr int K = std::remove_cvref_t<decltype(E)>::RowsAtCompileTime;
        Eigen::Map<Rows<K>>(&work.z[row]).noalias() = E * Eigen::Map<const Rows<K>>(&work.r[row]);
        row += K;
      }
    });
}

double sum_of_products(const std::vector<double>& a, const std::vector<double>& b) {
  double sum = 0;
  for (std::size_t i = 0; i < a.size(); ++i) sum += a[i] * b[i];
  return sum;
}

double largest(const std::vector<double>& a) {
  double result = 0;
  for (const double x : a) result = std::max(result, std::abs(x));
  return result;
}

}  // namespace

void require_valid(const ConjugateGradients& solver) {
  require(solver.iterations >= 1, "number of iterations", solver.iterations, "at least 1");
  require_in("tolerance", solver.tolerance, 0, 1e300, "m/s");
}

//! [conjugate_gradients]
template <class M>
int solve(const ConjugateGradients& solver, System<M>& system, std::vector<Velocity<M>>& velocities,
          ConjugateGradientWork<M>& work, Begin begin) {
  const int rows = system.rows();
  auto& [inverses, r, z, p, Ap, q] = work;
  for (auto* numbers : {&r, &z, &p, &Ap}) numbers->assign(rows, 0.0);
  invert_blocks(system, work);
  begin_sweeps(system, solver.warm_start, begin, velocities);
  rates_of(system, velocities, r);
  for (int i = 0; i < rows; ++i) r[i] = -(r[i] + system.bias[i] + system.gamma[i] * system.lambda[i]);
  double rz_before = 0, rz_first = 0;
  for (int k = 0; k < solver.iterations; ++k) {
    precondition(system, work);
    const double rz = sum_of_products(r, z);
    if (k == 0) rz_first = rz;
    if (largest(r) <= solver.tolerance || !(rz > rounding * rz_first)) return k;
    const double onward = k == 0 ? 0.0 : rz / rz_before;
    for (int i = 0; i < rows; ++i) p[i] = z[i] + onward * p[i];
    q.assign(velocities.size(), Velocity<M>::Zero());
    apply_all(system, p, q);
    rates_of(system, q, Ap);
    for (int i = 0; i < rows; ++i) Ap[i] += system.gamma[i] * p[i];
    const double step = rz / sum_of_products(p, Ap);
    for (int i = 0; i < rows; ++i) {
      system.lambda[i] += step * p[i];
      r[i] -= step * Ap[i];
    }
    for (std::size_t i = 0; i < velocities.size(); ++i) velocities[i] += step * q[i];
    rz_before = rz;
  }
  return solver.iterations;
}
//! [conjugate_gradients]

#define BYHAND_INSTANTIATE(M)                                                                                     \
  template int solve(const ConjugateGradients&, System<M>&, std::vector<Velocity<M>>&, ConjugateGradientWork<M>&, \
                     Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
