#include "solver/methods/equalities.hpp"

namespace byhand {

template <class M>
std::string refusal_unless_equalities(const Scene<M>& scene, const std::string& method) {
  if (!scene.colliders().shapes.empty())
    return method + " knows no contacts, and this scene has bodies that may touch";
  int number = 0;
  for (const auto& entry : scene.entries()) {
    const ConstraintStore<M>& store = scene.store(entry.kind);
    const std::string constraint = "constraint " + std::to_string(number++);
    if (store.bound != Bound::none) return method + " holds equalities alone, and " + constraint + " is bounded";
    if (store.position_rows < store.rows)
      return method + " holds equalities alone, and " + constraint + " is a spring";
    if (const double softness = store.softness(entry.index); softness > 0)
      return method + " holds constraints exactly, and " + constraint + " is soft: it gives way by " +
             text_of(softness) + " in a step";
  }
  return {};
}

template <class M>
void begin_equalities(const Scene<M>& scene, double h, EqualitiesWork<M>& work) {
  work.h = h;
  if (work.version == scene.version()) return;
  work.version = scene.version();
  scene.lay_out(solve_order(Layout::elimination, scene.graph(), M::dof, work.direct.plan), work.system);
  for (auto* numbers : {&work.offset, &work.change}) numbers->assign(work.system.rows(), 0.0);
}

template <class M>
void solve_rows(double regularisation, const Bodies<M>& bodies, EqualitiesWork<M>& work) {
  if (work.system.rows() == 0) return;
  const Direct solver{.regularisation = regularisation};
  solve_equations(solver, work.system, work.offset, bodies, work.direct, work.change);
  work.row_solves += direct_row_solves(solver, work.direct.plan, work.system.rows(), M::dof);
}

#define BYHAND_INSTANTIATE(M)                                                                    \
  template std::string refusal_unless_equalities(const Scene<M>&, const std::string&);           \
  template void begin_equalities(const Scene<M>&, double, EqualitiesWork<M>&);                   \
  template void solve_rows(double, const Bodies<M>&, EqualitiesWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
