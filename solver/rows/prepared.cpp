#include "solver/rows/prepared.hpp"

#include "solver/support/each_model.hpp"

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
inline Eigen::Matrix2d isotropic_inverse_of(const Eigen::Matrix2d& A) {
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
inline void prepare_run(std::span<const Block<PlaneBody, 3, Bound::manifold>> blocks,
                        const System<PlaneBody>& system, BlockSolve block_solve, double relaxation, double* D,
                        std::span<PreparedManifold> results) {
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

#define BYHAND_INSTANTIATE(M)                                                \
  template void prepare(const System<M>&, BlockSolve, double, Prepared<M>&); \
  template void prepare_to_watch(const System<M>&, double, Prepared<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
