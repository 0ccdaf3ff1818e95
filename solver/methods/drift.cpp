#include "solver/methods/drift.hpp"

namespace byhand {

template <class M>
void set_bias(const DriftCure& cure, double h, System<M>& system) {
  std::visit(
      [&](const auto& choice) {
        for (int i = 0; i < system.rows(); ++i) system.bias[i] = bias(choice, system.C[i], h);
      },
      cure);
  if (!system.bounded) return;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    if constexpr (B == Bound::interval)
      for (const auto& block : blocks)
        if (system.lower[block.row] == 0 && system.C[block.row] > 0)
          system.bias[block.row] = system.C[block.row] / h;
  });
}

#define BYHAND_INSTANTIATE(M) template void set_bias(const DriftCure&, double, System<M>&)
BYHAND_INSTANTIATE(PlaneParticle);
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceParticle);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
