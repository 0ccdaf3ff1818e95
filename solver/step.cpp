#include "solver/advance.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

BYHAND_DEFINE_COPIES(StepWork)

template <class M>
void advance(Scene<M>& scene, const VelocityStepping& method, double step, Work<M>& work) {
  advance<M, RowSolver, DriftCure>(scene, method, step, work);
}

template <class M>
void lay_out(const Scene<M>& scene, const RowSolver& solver, Work<M>& work) {
  detail::lay_out(scene, solver, work);
}

template <class M>
void solve_rows(const RowSolver& solver, Bodies<M>& bodies, Work<M>& work, Begin begin) {
  detail::solve_rows(solver, bodies, work, begin);
}

template void require_valid(const VelocityStepping&);

// Where it can be either, `advance` is that of VelocityStepping, which the general one follows.
#define BYHAND_INSTANTIATE(M)                                         \
  template struct StepWork<M>;                                        \
  BYHAND_STEPPING(M, RowSolver, DriftCure);                           \
  template void lay_out(const Scene<M>&, const RowSolver&, Work<M>&); \
  template void solve_rows(const RowSolver&, Bodies<M>&, Work<M>&, Begin)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
