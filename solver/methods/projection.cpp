#include "solver/methods/projection.hpp"

#include "solver/methods/positions.hpp"

namespace byhand {
namespace {

template <class M, int K, Bound B>
void project(const Projection& cure, const ConstraintStore<M>& store, Block<M, K, B>& block, Bodies<M>& bodies) {
  Rows<K> C;
  store.linearise(bodies, block, C.data());
  if constexpr (B != Bound::none) C = (C.array() + cure.slop).min(0.0);
  for (int k = store.position_rows; k < K; ++k) C[k] = 0;
  Eigen::Matrix<double, K, K> A = inverse_effective_mass(block.J, block.W);
  A.diagonal().array() += store.softness(block.constraint);
  constexpr double infinity = std::numeric_limits<double>::infinity();
  const ImpulseBounds bounds = {0, B == Bound::interval ? infinity : 0.0};
  const Rows<K> change = cure.share * bounded_newton<B, K>(A, C, Rows<K>::Zero(), bounds);
  displace(block, change, bodies.pose);
}

}  // namespace

//! [project]
template <class M>
long long project(const Projection& cure, Scene<M>& scene) {
  long long solved = 0;
  Bodies<M>& bodies = scene.state();
  for (int sweep = 0; sweep < cure.sweeps; ++sweep)
    for (const auto& entry : scene.entries()) {
      const ConstraintStore<M>& store = scene.store(entry.kind);
      if (store.position_rows == 0) continue;
      for_type<M>(store.block_type, [&](auto type) {
        using Blocks = std::tuple_element_t<type, decltype(System<M>::blocks)>;
        typename Blocks::value_type block;
        block.body1 = entry.body1;
        block.body2 = entry.body2;
        block.moves1 = moves(bodies.inverse_mass[entry.body1]);
        block.moves2 = moves(bodies.inverse_mass[entry.body2]);
        block.constraint = entry.index;
        project(cure, store, block, bodies);
      });
      solved += store.position_rows;
    }
  return solved;
}
//! [project]

#define BYHAND_INSTANTIATE(M) template long long project(const Projection&, Scene<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
