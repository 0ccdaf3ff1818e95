#include "solver/methods/equalities.hpp"

namespace byhand {

template <class M>
std::string refusal_unless_equalities(const Scene<M>& scene, const char* method) {
  const auto refusal = [&](const std::string& reason) { return std::string(method) + reason; };
  if (!scene.colliders().shapes.empty())
    return refusal(" knows no contacts, and this scene has bodies that may touch");
  for (const auto& entry : scene.entries()) {
    const ConstraintStore<M>& store = scene.store(entry.kind);
    const double softness = store.softness(entry.index);
    const bool equality = store.bound == Bound::none && store.position_rows == store.rows;
    if (equality && softness == 0) continue;
    const std::string constraint = "constraint " + std::to_string(entry.id);
    if (store.bound != Bound::none) return refusal(" holds equalities alone, and " + constraint + " is bounded");
    if (!equality) return refusal(" holds equalities alone, and " + constraint + " is a spring");
    return refusal(" holds constraints exactly, and " + constraint + " is soft: it gives way by " +
                   text_of(softness) + " in a step");
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

#define BYHAND_INSTANTIATE(M)                                                   \
  template std::string refusal_unless_equalities(const Scene<M>&, const char*); \
  template void begin_equalities(const Scene<M>&, double, EqualitiesWork<M>&);  \
  template void solve_rows(double, const Bodies<M>&, EqualitiesWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
