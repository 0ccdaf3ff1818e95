#include "solver/rows/operators.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
void apply_all(const System<M>& system, const std::vector<double>& lambda, std::vector<Velocity<M>>& velocities,
               double sign) {
  double* V = numbers<M>(velocities);
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks)
      apply<M, K>(block, Rows<K>(sign * Eigen::Map<const Rows<K>>(&lambda[block.row])), V);
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

#define BYHAND_INSTANTIATE(M)                                                                               \
  template void apply_all(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&, double); \
  template void rates_of(const System<M>&, const std::vector<Velocity<M>>&, std::vector<double>&);          \
  template void multiply(const System<M>&, const std::vector<double>&, std::vector<Velocity<M>>&,           \
                         std::vector<double>&);                                                             \
  template void errors_of(const System<M>&, const std::vector<Velocity<M>>&, const std::vector<double>&,    \
                          std::vector<double>&);                                                            \
  template void hold_within_bounds(const System<M>&, std::vector<double>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
