#include "solver/methods/soft_constraints.hpp"

namespace byhand {

void require_valid(const SoftConstraints& cure) {
  require_positive("frequency", cure.frequency, "rad/s");
  require_in("damping ratio", cure.damping_ratio, 0, 1e300);
  require_in("slop", cure.slop, 0, 1e300, "m");
  require(cure.speed_cap > 0, "speed cap", cure.speed_cap, "above zero [m/s]");
}

template <class M>
void soften(const SoftConstraints& cure, double h, System<M>& system, std::vector<double>& own) {
  const double a2 = softness_of(cure, h).a2;
  own = system.gamma;
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (const auto& block : part<type>(system.blocks, run))
        for (int row = block.row, k = 0; k < run.drifting; ++row, ++k) {
          const bool open = system.C[row] > 0 && one_sided(system, block, k);
          if (own[row] == 0 && !open) system.gamma[row] = block.J.matrix.row(k).dot(block.W.matrix.row(k)) / a2;
        }
    });
}

#define BYHAND_INSTANTIATE(M) \
  template void soften(const SoftConstraints&, double, System<M>&, std::vector<double>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
