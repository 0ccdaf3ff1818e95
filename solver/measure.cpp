#include "solver/measure.hpp"

namespace byhand {

template <class M>
double residual(const System<M>& system, const std::vector<Velocity<M>>& V) {
  double largest = 0;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      const int row = block.row;
      const Eigen::Map<const Rows<K>> lambda(&system.lambda[row]), gamma(&system.gamma[row]),
          bias(&system.bias[row]);
      Rows<K> error = dot(block.J, V[block.body1], V[block.body2]) + bias + gamma.cwiseProduct(lambda);
      if constexpr (B != Bound::none) {
        // The change that one more step of (17) would make within the bounds, in units of the error.
        const double A = inverse_effective_mass(block.J, block.W).diagonal().maxCoeff() + gamma.maxCoeff();
        if (A == 0) continue;
        const double normal = B == Bound::friction ? system.lambda[block.normal_row] : 0.0;
        error = A * (bounded<K, B>(lambda - error / A, system.lower[row], system.upper[row], normal) - lambda);
      }
      largest = std::max(largest, error.cwiseAbs().maxCoeff());
    }
  });
  return largest;
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
      const double error = store.bound == Bound::none ? std::abs(C[k]) : std::max(0.0, -C[k]);
      largest = std::max(largest, error);
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
  simulation.step(h);
  exact.step(h);
  return largest_difference<M>(simulation.scene.bodies().velocity, exact.scene.bodies().velocity);
}

#define BYHAND_INSTANTIATE(M)                                                  \
  template PositionError position_error(const Scene<M>&);                      \
  template double residual(const System<M>&, const std::vector<Velocity<M>>&); \
  template double algebraic_error(Simulation<M>, double)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
