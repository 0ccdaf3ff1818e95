#include "solver/measure.hpp"

#include "solver/rows/operators.hpp"
#include "solver/rows/residual.hpp"
#include "solver/support/each_model.hpp"

namespace byhand {

template <class M>
double residual(const System<M>& system, const std::vector<Velocity<M>>& V) {
  RowScales scales;
  find_scales(system, scales);
  std::vector<double> error(system.rows());
  errors_of(system, V, system.lambda, error);
  return residual(system, system.lambda, error, scales).largest;
}

template <class M>
PositionError position_error(const Scene<M>& scene, const ContactManager<M>& contacts) {
  double largest = 0, sum = 0;
  int rows = 0;
  for_each_constraint(scene, contacts, [&](const ConstraintStore<M>& store, const auto& entry) {
    if (store.position_rows == 0) return;
    double C[most_rows<M>];
    store.write_value(entry.index, scene.bodies(), C);
    for (int k = 0; k < store.position_rows; ++k) {
      const double error = store.bound == Bound::none ? std::abs(C[k]) : larger(0, -C[k]);
      largest = larger(largest, error);
      sum += error * error;
      ++rows;
    }
  });
  return {largest, rows > 0 ? std::sqrt(sum / rows) : 0.0};
}

#define BYHAND_INSTANTIATE(M)                                                       \
  template PositionError position_error(const Scene<M>&, const ContactManager<M>&); \
  template double residual(const System<M>&, const std::vector<Velocity<M>>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
