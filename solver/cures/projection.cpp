#include "solver/cures/projection.hpp"

#include "solver/cures/bounded_newton.hpp"
#include "solver/support/each_model.hpp"
#include "solver/work.hpp"

namespace byhand {
namespace {

template <class M, int K, Bound B>
void project(const Projection& cure, const ConstraintStore<M>& store, Block<M, K, B>& block, Bodies<M>& bodies) {
  Rows<K> C;
  store.linearise(bodies, block, C.data());
  for (int k = 0; k < K; ++k) {
    if constexpr (B != Bound::none) C[k] = std::min(C[k] + cure.slop, 0.0);
    if (k >= store.position_rows) C[k] = 0;
  }
  Eigen::Matrix<double, K, K> A = inverse_effective_mass(block.J, block.W);
  for (int k = 0; k < K; ++k) A(k, k) += store.softness(block.constraint);
  const ImpulseBounds bounds = {0, B == Bound::interval ? std::numeric_limits<double>::infinity() : 0.0};
  apply_displacement<M, K, B>(
      block, cure.share * bounded_newton<B, K>(A, C, Rows<K>::Zero(), bounds),
      [&](int body, const Velocity<M>& way) { move<M, double>(bodies.pose[body], way, 1); });
}

/// Friction has no C.
template <class M, int K>
void project(const Projection&, const ConstraintStore<M>&, Block<M, K, Bound::friction>&, Bodies<M>&) {}

}  // namespace

template <class M>
long long project(const Projection& cure, Scene<M>& scene, const ContactManager<M>& contacts) {
  long long solved = 0;
  Bodies<M>& bodies = scene.state();
  for (int sweep = 0; sweep < cure.sweeps && (sweep == 0 || solved > 0); ++sweep)
    for_each_constraint(scene, contacts, [&](const ConstraintStore<M>& store, const auto& entry) {
      if (store.position_rows == 0) return;
      for_type<M>(store.block_type, [&](auto type) {
        typename std::tuple_element_t<type, decltype(System<M>::blocks)>::value_type block;
        const bool moves1 = moves(bodies.inverse_mass[entry.body1]),
                   moves2 = moves(bodies.inverse_mass[entry.body2]);
        static_cast<BlockHeader&>(block) = {entry.body1, entry.body2, moves1, moves2, 0, 0, entry.index};
        project(cure, store, block, bodies);
      });
      solved += store.position_rows;
    });
  return solved;
}

template <class M>
void Projection::after_move(Stage<M>& stage) const {
  stage.work.contacts.follow_balls(stage.scene, stage.work.system);
  const long long rows = project(*this, stage.scene, stage.work.contacts);
  stage.work.row_solves += rows;
  stage.work.executed.projected_rows += rows;
}

#define BYHAND_INSTANTIATE(M)                                                         \
  template long long project(const Projection&, Scene<M>&, const ContactManager<M>&); \
  template void Projection::after_move(Stage<M>&) const
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
