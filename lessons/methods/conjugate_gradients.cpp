#include "lessons/methods/conjugate_gradients.hpp"

#include <numeric>

#include "lessons/methods/gradient.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {
namespace {

// Of r·z relative to its first value. Below this r is rounding, and so are the directions that follow from it.
constexpr double rounding = 1e-30;

/// E of each block.
template <class M>
void invert_blocks(const System<M>& system, ConjugateGradientWork<M>& work) {
  for_each_block_with(system, work.inverses, [&]<int K, Bound B>(const Block<M, K, B>& block, auto& E) {
    auto A = inverse_effective_mass(block.J, block.W);
    for (int k = 0; k < K; ++k) A(k, k) += system.gamma[block.row + k];
    E = inverse_or_zero<K>(A);
  });
}

/// z = E r.
template <class M>
void precondition(const System<M>& system, ConjugateGradientWork<M>& work) {
  for_each_block_with(system, work.inverses, [&]<int K, Bound B>(const Block<M, K, B>& block, const auto& E) {
    Eigen::Map<Rows<K>>(&work.z[block.row]).noalias() = E * Eigen::Map<const Rows<K>>(&work.r[block.row]);
  });
}

double sum_of_products(const std::vector<double>& a, const std::vector<double>& b) {
  return std::inner_product(a.begin(), a.end(), b.begin(), 0.0);
}

}  // namespace

void require_valid(const ConjugateGradients& solver) { require_valid_descent(solver); }

template <class M>
Solution ConjugateGradients::solve(System<M>& system, Bodies<M>& bodies, ConjugateGradientWork<M>& work,
                                   Begin begin) const {
  std::vector<Velocity<M>>& velocities = bodies.velocity;
  const int rows = system.rows();
  auto& [inverses, scales, r, z, p, Ap, q] = work;
  for (auto* numbers : {&z, &p, &Ap}) numbers->assign(rows, 0.0);
  q.resize(velocities.size());
  invert_blocks(system, work);
  const double speed = begin_descent(system, warm_start, begin, bodies, scales, r);
  for (double& error : r) error = -error;
  double rz_before = 0, rz_first = 0;
  for (int k = 0;; ++k) {
    precondition(system, work);
    const double rz = sum_of_products(r, z);
    if (k == 0) rz_first = rz;
    const Residual reached = residual(system, system.lambda, r, scales);
    const bool converged = reached.within(tolerance, speed);
    if (converged || !(rz > rounding * rz_first) || k == iterations) return {k, 0, reached.largest, converged};
    const double share = k == 0 ? 0.0 : rz / rz_before;
    for (int i = 0; i < rows; ++i) p[i] = z[i] + share * p[i];
    multiply(system, p, q, Ap);
    const double step = rz / sum_of_products(p, Ap);
    for (int i = 0; i < rows; ++i) {
      system.lambda[i] += step * p[i];
      r[i] -= step * Ap[i];
    }
    for (std::size_t i = 0; i < velocities.size(); ++i) velocities[i] += step * q[i];
    rz_before = rz;
  }
}

#define BYHAND_INSTANTIATE(M) \
  template Solution ConjugateGradients::solve(System<M>&, Bodies<M>&, ConjugateGradientWork<M>&, Begin) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
