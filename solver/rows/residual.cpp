#include "solver/rows/residual.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

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
        result.largest_lambda = larger(result.largest_lambda, scales.speed[row + k] * std::abs(now[k]));
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

#define BYHAND_INSTANTIATE(M)                                                                          \
  template void find_scales(const System<M>&, RowScales&);                                             \
  template Residual residual(const System<M>&, const std::vector<double>&, const std::vector<double>&, \
                             const RowScales&);                                                        \
  template double fastest(const System<M>&, const std::vector<Velocity<M>>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
