#include "solver/measure.hpp"

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
PositionError position_error(const Scene<M>& scene) {
  double largest = 0, sum = 0;
  int rows = 0;
  for (const auto& entry : scene.entries()) {
    const ConstraintStore<M>& store = scene.store(entry.kind);
    if (store.position_rows == 0) continue;
    double C[6];  // no block has more rows
    store.write_value(entry.index, scene.bodies(), C);
    for (int k = 0; k < store.position_rows; ++k) {
      const double error = store.bound == Bound::none ? std::abs(C[k]) : larger(0, -C[k]);
      largest = larger(largest, error);
      sum += error * error;
      ++rows;
    }
  }
  return {largest, rows > 0 ? std::sqrt(sum / rows) : 0.0};
}

template <class M>
double algebraic_error(Simulation<M> simulation, double h) {
  Simulation<M> exact = simulation;
  exact.method.solver = Direct{Factorisation::dense};
  try {
    simulation.step(h);
    exact.step(h);
  } catch (const NotFinite&) {
    return std::numeric_limits<double>::quiet_NaN();
  }
  const auto &V = simulation.scene.bodies().velocity, &exact_V = exact.scene.bodies().velocity;
  double largest = 0;
  for (std::size_t i = 0; i < V.size(); ++i)
    for (int k = 0; k < M::dof; ++k) largest = larger(largest, std::abs(V[i][k] - exact_V[i][k]));
  return largest;
}

#define BYHAND_INSTANTIATE(M)                                                  \
  template PositionError position_error(const Scene<M>&);                      \
  template double residual(const System<M>&, const std::vector<Velocity<M>>&); \
  template double algebraic_error(Simulation<M>, double)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
