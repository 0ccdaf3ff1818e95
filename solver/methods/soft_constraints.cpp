#include "solver/methods/soft_constraints.hpp"

namespace byhand {

void require_valid(const SoftConstraints& cure) {
  require_positive("frequency", cure.frequency, "rad/s");
  require_in("damping ratio", cure.damping_ratio, 0, 1e300);
  require_valid_slop(cure.slop, cure.speed_cap);
}

template <class M>
void soften(const SoftConstraints& cure, double h, System<M>& system, SoftWork& work) {
  const double a1 = 2 * cure.damping_ratio + h * cure.frequency, a2 = h * cure.frequency * a1;
  work.gamma = system.gamma;
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (const auto& block : part<type>(system.blocks, run))
        for (int row = block.row, k = 0; k < run.position_rows; ++row, ++k) {
          const bool open = system.C[row] > 0 && one_sided(system, block, k);
          if (work.gamma[row] == 0 && !open)
            system.gamma[row] = block.J.matrix.row(k).dot(block.W.matrix.row(k)) / a2;
        }
    });
}

template <class M>
void relax(const SoftConstraints& cure, const RowSolver& solver, double h, Scene<M>& scene, RowWork<M>& rows,
           SoftWork& work) {
  if (!cure.relax) return;
  System<M>& system = rows.system;
  if (cure.refresh) {
    work.rate = system.rate;
    scene.write_rows(system, h);
    system.rate = work.rate;  // a spring's, or it would push twice
  } else {
    system.gamma = work.gamma;
  }
  set_bias({}, h, system);
  solve_rows(solver, scene.state(), rows, Begin::resume);
}

#define BYHAND_INSTANTIATE(M)                                                  \
  template void soften(const SoftConstraints&, double, System<M>&, SoftWork&); \
  template void relax(const SoftConstraints&, const RowSolver&, double, Scene<M>&, RowWork<M>&, SoftWork&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
