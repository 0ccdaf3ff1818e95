#include "solver/drift.hpp"

namespace byhand {

void require_valid_slop(double slop, double speed_cap) {
  require_in("slop", slop, 0, 1e300, "m");
  require(speed_cap > 0, "speed cap", speed_cap, "above zero [m/s]");
}

void require_valid(const Baumgarte& cure) {
  if (cure.reading == BetaReading::per_step)
    require_in("beta", cure.beta, 0, 3);
  else
    require_in("beta", cure.beta, 0, 1e6, "1/s");
  require_valid_slop(cure.slop, cure.speed_cap);
}

template <class M>
void set_bias(const Correction& correction, double h, System<M>& system) {
  const auto [rate, slop, speed_cap] = correction;
  for (int i = 0; i < system.rows(); ++i) system.bias[i] = rate * system.C[i] + system.rate[i];
  if (!system.bounded) return;
  system.for_each_run([&, rate = rate, slop = slop, cap = speed_cap]<int K, Bound B>(
                          std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks)
      for (int k = 0; k < K; ++k)
        if (one_sided(system, block, k)) {
          const int row = block.row + k;
          const double C = system.C[row];
          const double b = C > 0 ? C / h : std::max(rate * std::min(C + slop, 0.0), -cap);
          system.bias[row] = b + system.rate[row];
        }
  });
}

#define BYHAND_INSTANTIATE(M) template void set_bias(const Correction&, double, System<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
