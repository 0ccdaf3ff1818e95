#include "solver/methods/prepared.hpp"

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

/// E of friction in space: one number for both tangents, the inverse of the largest eigenvalue of A. Held to its
/// disc, λ comes to rest along -E JV; only a multiple of the identity makes that the direction against the slip.
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
  if constexpr (K == 2 && B == Bound::ball)
    minus_E = -relaxation * isotropic_inverse_of(A);
  else
    minus_E = -relaxation * inverse_of<K>(A, block_solve);
  result.body1 = block.body1;
  result.body2 = block.body2;
  result.moves1 = block.moves1;
  result.moves2 = block.moves2;
  result.row = block.row;
  result.leader = block.leader;
  result.J.noalias() = minus_E * block.J.matrix;
  result.W = block.W;
  result.bias.setZero();
  for (int k = 0; k < K; ++k)
    for (int l = 0; l < K; ++l) {
      result.bias[k] += minus_E(k, l) * bias[l];
      result.gamma[k][l] = minus_E(k, l) * gamma[l];
    }
  result.lower = system.lower[block.row];
  result.upper = system.upper[block.row];
}

void prepare(const Block<PlaneBody, 3, Bound::face>& block, const System<PlaneBody>& system,
             BlockSolve block_solve, double relaxation, PreparedBlock<PlaneBody, 3, Bound::face>& result) {
  Eigen::Matrix3d A = inverse_effective_mass(block.J, block.W);
  result.body1 = block.body1;
  result.body2 = block.body2;
  result.moves1 = block.moves1;
  result.moves2 = block.moves2;
  result.row = block.row;
  result.J = block.J.matrix;
  result.W = block.W;
  for (int k = 0; k < 3; ++k) {
    result.bias[k] = system.bias[block.row + k];
    result.gamma[k] = system.gamma[block.row + k];
    A(k, k) += result.gamma[k];
  }
  const Eigen::Matrix2d E = inverse_or_zero<2>(A.topLeftCorner<2, 2>());
  result.A00 = A(0, 0);
  result.A01 = A(0, 1);
  result.A11 = A(1, 1);
  result.A02 = A(0, 2);
  result.A12 = A(1, 2);
  result.E00 = E(0, 0);
  result.E01 = E(0, 1);
  result.E11 = E(1, 1);
  result.E22 = A(2, 2) > 0 ? 1 / A(2, 2) : 0.0;
  result.coefficient = system.upper[block.row];
  result.relaxation = relaxation;
  result.row_by_row = block_solve == BlockSolve::row_by_row;
}

}  // namespace

template <class M>
void prepare(const System<M>& system, BlockSolve block_solve, double relaxation, Prepared<M>& prepared) {
  prepared.soft = std::any_of(system.gamma.begin(), system.gamma.end(), [](double gamma) { return gamma != 0; });
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      auto& results = std::get<type>(prepared.blocks);
      results.resize(std::get<type>(system.blocks).size());
      const auto blocks = part<type>(system.blocks, run);
      for (int i = 0; i < run.count; ++i)
        prepare(blocks[i], system, block_solve, relaxation, results[run.first + i]);
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

#define BYHAND_INSTANTIATE(M)                                                                       \
  template void prepare(const System<M>&, BlockSolve, double, Prepared<M>&);                        \
  template void apply_all(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&); \
  template void rates_of(const System<M>&, const std::vector<Velocity<M>>&, std::vector<double>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
