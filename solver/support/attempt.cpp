#include "solver/support/attempt.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
void refuse_not_finite(const Scene<M>& scene, const State<M>& came) {
  require_finite<M>(scene.bodies().pose, scene.bodies().velocity, "");
  for (const auto& entry : scene.entries()) {
    const ConstraintStore<M>& store = scene.store(entry.kind);
    double C[most_rows<M>];
    store.write_value(entry.index, scene.bodies(), C);
    if (!std::all_of(C, C + store.rows, [](double c) { return std::isfinite(c); }))
      throw NotFinite("constraint " + std::to_string(entry.id) + " has a value that is not a finite number");
  }
  require_finite<M>(came.pose, came.velocity, " after a step, which was taken back");
}

#define BYHAND_INSTANTIATE(M) template void refuse_not_finite(const Scene<M>&, const State<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
