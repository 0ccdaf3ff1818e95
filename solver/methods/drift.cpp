#include "solver/methods/drift.hpp"

namespace byhand {

template <class M>
void set_bias(const DriftCure& cure, double h, System<M>& system) {
  std::visit(
      [&](const auto& choice) {
        for (int i = 0; i < system.rows(); ++i) system.bias[i] = bias(choice, system.C[i], h) + system.rate[i];
        if (!system.bounded) return;
        const auto set_one_sided = [&](int row) {
          const double C = system.C[row];
          system.bias[row] = (C > 0 ? C / h : bias_of_overlap(choice, C, h)) + system.rate[row];
        };
        system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
          for (const auto& block : blocks) {
            for (int k = 0; k < K; ++k)
              if (one_sided(system, block, k)) set_one_sided(block.row + k);
          }
        });
      },
      cure);
}

#define BYHAND_INSTANTIATE(M) template void set_bias(const DriftCure&, double, System<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
