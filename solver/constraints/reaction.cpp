#include "solver/constraints/reaction.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

namespace {

/// The first row of a constraint that took part in the last step, whatever has changed since.
template <class M>
int row_in_step(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  const auto& stamps = work.system.stamp_of;
  const std::uint64_t stamp = scene.entries()[scene.place(constraint)].stamp;
  const auto at = std::ranges::lower_bound(stamps, stamp);
  require(at != stamps.end() && *at == stamp, "constraint", constraint, "one that took part in the last step");
  return work.system.row_of[at - stamps.begin()];
}

}  // namespace

template <class M>
std::span<const double> impulse(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  const int row = row_in_step(scene, work, constraint),
            rows = scene.store(scene.entries()[scene.place(constraint)].kind).rows;
  return std::span(work.system.lambda).subspan(row, rows);
}

template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  Reaction<M> result;
  const int row = row_in_step(scene, work, constraint);
  for_each_block(work.system, [&]<int K, Bound B>(const Block<M, K, B>& block, const Run&) {
    if (block.row != row) return;
    const Rows<K> force = Eigen::Map<const Rows<K>>(&work.system.lambda[row]) / work.h;
    result.force = block.J.l2().transpose() * force;
    if constexpr (M::angular > 0) {
      result.torque1 = block.J.a1().transpose() * force;
      result.torque2 = block.J.a2().transpose() * force;
    }
  });
  return result;
}

#define BYHAND_INSTANTIATE(M)                                                         \
  template std::span<const double> impulse(const Scene<M>&, const StepWork<M>&, int); \
  template Reaction<M> reaction(const Scene<M>&, const StepWork<M>&, int)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
