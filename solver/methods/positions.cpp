#include "solver/methods/positions.hpp"

#include "solver/contact/restitution.hpp"

namespace byhand {

template <class M>
bool begin_rows(Scene<M>& scene, PositionWork<M>& work) {
  work.contacts.find(scene);
  const bool anew = lay_out_naturally(scene, work);
  work.contacts.write_impulses(work.system);
  for (auto* numbers : {&work.impulse, &work.from, &work.target}) numbers->resize(work.system.rows());
  return anew;
}

template <class M>
void write_targets(const Scene<M>& scene, double h, PositionWork<M>& work) {
  System<M>& system = work.system;
  scene.write_rows(system, h);
  note_approach(system, scene.bodies().velocity, work.approach);
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (const auto& block : part<type>(system.blocks, run)) {
        constexpr int K = decltype(block.J.matrix)::RowsAtCompileTime;
        Rows<K> C = Rows<K>::Zero();
        if (run.position_rows < K) scene.store(run.kind).write_value(block.constraint, scene.bodies(), C.data());
        for (int k = 0; k < K; ++k) {
          work.from[block.row + k] = k < run.position_rows ? 0 : C[k];
          work.target[block.row + k] = h * system.rate[block.row + k];
        }
      }
    });
}

template <class M>
Velocity<M> velocity_between(const Pose<M>& before, const Pose<M>& after, double h) {
  Velocity<M> V;
  V.template head<M::linear>() = (after.position - before.position) / h;
  if constexpr (M::angular == 1) V[M::linear] = principal_angle(after.rotation * inverse(before.rotation)) / h;
  if constexpr (M::angular == 3) V.template tail<3>() = turn_of(after.rotation * inverse(before.rotation)) / h;
  return V;
}

template <class M>
void velocities_between(const std::vector<Pose<M>>& before, double h, Bodies<M>& bodies) {
  for (int i = 0; i < bodies.size(); ++i)
    if (moves(bodies.inverse_mass[i])) bodies.velocity[i] = velocity_between<M>(before[i], bodies.pose[i], h);
}

namespace {

/// One contact's parting, if it bounces; returns whether it does.
template <class M, int K, Bound B>
bool bounce(const Scene<M>& scene, int kind, Block<M, K, B>& block, double threshold, Bodies<M>& bodies,
            PositionWork<M>& work) {
  System<M>& system = work.system;
  Eigen::Map<Rows<K>> lambda(&system.lambda[block.row]);
  Rows<K> parting = Rows<K>::Zero();
  for (int k = 0; k < bouncing<K, B>; ++k) {
    const double approach = work.approach[block.row + k];
    if (lambda[k] > 0 && approach < -threshold) parting[k] = -system.restitution[block.row] * approach;
  }
  if (parting.isZero(0)) return false;
  Rows<K> C;
  scene.store(kind).linearise(bodies, block, C.data());
  Velocity<M>&V1 = bodies.velocity[block.body1], &V2 = bodies.velocity[block.body2];
  const ImpulseBounds bounds{system.lower[block.row], system.upper[block.row]};
  const Rows<K> change = bounded_newton<B, K>(inverse_effective_mass(block.J, block.W),
                                              dot(block.J, V1, V2) - parting, lambda, bounds);
  if (block.moves1) V1 += block.W.side1().transpose() * change;
  if (block.moves2) V2 += block.W.side2().transpose() * change;
  lambda.setZero();
  return true;
}

}  // namespace

template <class M>
void end_rows(Scene<M>& scene, double h, double threshold, PositionWork<M>& work) {
  System<M>& system = work.system;
  for (int row = 0; row < system.rows(); ++row) system.lambda[row] = work.impulse[row] / h;
  if (work.approach.empty()) return;
  for (const Run& run : system.runs)
    for_type<M>(run.type, [&](auto type) {
      for (auto& block : part<type>(system.blocks, run))
        if (bounce(scene, run.kind, block, threshold, scene.state(), work))
          work.row_solves += block.J.matrix.rows();
    });
}

#define BYHAND_INSTANTIATE(M)                                                        \
  template bool begin_rows(Scene<M>&, PositionWork<M>&);                             \
  template void write_targets(const Scene<M>&, double, PositionWork<M>&);            \
  template Velocity<M> velocity_between(const Pose<M>&, const Pose<M>&, double);     \
  template void velocities_between(const std::vector<Pose<M>>&, double, Bodies<M>&); \
  template void end_rows(Scene<M>&, double, double, PositionWork<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
