#include "solver/constraints/reaction.hpp"

#include "solver/support/each_model.hpp"

namespace byhand {

namespace {

/// The place in the system of a constraint that took part in the last step.
template <class M>
int place_in_step(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  int place = scene.place(constraint);
  bool took_part = work.version == scene.version();
  if (!took_part && constraint >= 0) {  // other constraints have changed since: look for its stamp
    const std::uint64_t stamp = scene.entries()[place].stamp;
    const auto& stamps = work.system.stamp_of;
    const auto at = std::lower_bound(stamps.begin(), stamps.end(), stamp);
    took_part = at != stamps.end() && *at == stamp;
    place = static_cast<int>(at - stamps.begin());
  }
  require(took_part, "constraint", constraint, "one that took part in the last step");
  return place;
}

}  // namespace

template <class M>
std::span<const double> impulse(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  const int row = work.system.row_of[place_in_step(scene, work, constraint)],
            rows = scene.store(scene.entries()[scene.place(constraint)].kind).rows;
  return std::span(work.system.lambda).subspan(row, rows);
}

template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  Reaction<M> result;
  const int row = work.system.row_of[place_in_step(scene, work, constraint)];
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
