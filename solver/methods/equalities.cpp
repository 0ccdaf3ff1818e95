#include "solver/methods/equalities.hpp"

namespace byhand {

template <class M>
void solve_rows(double regularisation, const Bodies<M>& bodies, EqualitiesWork<M>& work) {
  if (work.system.rows() == 0) return;
  const Direct solver{.regularisation = regularisation};
  solve_equations(solver, work.system, work.offset, bodies, work.direct, work.change);
  work.row_solves += direct_row_solves(solver, work.direct.plan, work.system.rows(), M::dof);
}

#define BYHAND_INSTANTIATE(M) template void solve_rows(double, const Bodies<M>&, EqualitiesWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
