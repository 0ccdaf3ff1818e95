#include "solver/measure.hpp"

namespace byhand {

template <class M>
double residual(const System<M>& system, const std::vector<Velocity<M>>& V) {
  double largest = 0;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const Eigen::Map<const Rows<K>> lambda(&system.lambda[block.row]), gamma(&system.gamma[block.row]),
          bias(&system.bias[block.row]);
      Rows<K> error = dot(block.J, V[block.body1], V[block.body2]) + bias + gamma.cwiseProduct(lambda);
      if constexpr (B != Bound::none) {
        // What a step along -error of one more (17) would still change, in units of the error.
        const double A = inverse_effective_mass(block.J, block.W).diagonal().maxCoeff() + gamma.maxCoeff();
        if (A == 0) continue;
        const double leader = B == Bound::ball ? system.lambda[block.leader] : 0.0;
        error = A * (bounded<K, B>(lambda - error / A, system.lower[block.row], system.upper[block.row], leader) -
                     lambda);
      }
      largest = std::max(largest, error.cwiseAbs().maxCoeff());
    }
  });
  return largest;
}

#define BYHAND_INSTANTIATE(M) template double residual(const System<M>&, const std::vector<Velocity<M>>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
