#include "solver/cures/soft_constraints.hpp"

#include "solver/support/each_model.hpp"
#include "solver/work.hpp"

namespace byhand {

/// The constraints' own γ and target rate, by row.
struct SoftWork {
  std::vector<double> gamma, target_rate;
};

/// γ = A/a₂ for rows that have a C and no softness of their own. Open contacts stay hard.
template <class M>
void SoftConstraints::begin(Stage<M>& stage) const {
  System<M>& system = stage.work.system;
  SoftWork& own = kept_as<SoftWork>(stage.kept);
  const double a1 = 2 * damping_ratio + stage.h * frequency, a2 = stage.h * frequency * a1;
  own.gamma = system.gamma;
  for_each_block(system, [&](const auto& block, const Run& run) {
    for (int row = block.row, k = 0; k < run.position_rows; ++row, ++k) {
      const bool open = system.C[row] > 0 && one_sided(system, block, k);
      if (own.gamma[row] == 0 && !open) system.gamma[row] = inverse_effective_mass(block.J, block.W, k) / a2;
    }
  });
}

/// Solves the rows again, hard and without bias, from the current λ.
template <class M>
void SoftConstraints::after_move(Stage<M>& stage) const {
  if (!relax) return;
  System<M>& system = stage.work.system;
  SoftWork& own = kept_as<SoftWork>(stage.kept);
  if (refresh) {
    own.target_rate = system.target_rate;
    write_rows(stage.scene, stage.h, stage.work);
    system.target_rate = own.target_rate;  // springs keep theirs, or they would act twice
  } else {
    system.gamma = own.gamma;
  }
  set_bias({}, stage.h, system);
  stage.solve_rows_again();
}

#define BYHAND_INSTANTIATE(M)                            \
  template void SoftConstraints::begin(Stage<M>&) const; \
  template void SoftConstraints::after_move(Stage<M>&) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
