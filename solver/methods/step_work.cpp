#include "solver/methods/step_work.hpp"

#include <numeric>

namespace byhand {

std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan) {
  if (layout == Layout::coloured) return coloured_order(graph);
  if (layout == Layout::elimination) {
    plan = plan_elimination(graph, dof);
    return plan.order;
  }
  std::vector<int> order(graph.edges.size());
  std::iota(order.begin(), order.end(), 0);
  if (layout == Layout::reverse) std::reverse(order.begin(), order.end());
  return order;
}

template <class M>
bool lay_out_naturally(const Scene<M>& scene, StepWork<M>& work) {
  if (work.version == scene.version() && work.layout == Layout::natural) return false;
  work.version = scene.version();
  work.layout = Layout::natural;
  std::vector<int> order(scene.count());
  std::iota(order.begin(), order.end(), 0);
  scene.lay_out(order, work.system);
  return true;
}

template <class M>
bool has_bounds(const Scene<M>& scene) {
  const auto& entries = scene.entries();
  return !scene.colliders().shapes.empty() || std::any_of(entries.begin(), entries.end(), [&](const auto& entry) {
    return scene.store(entry.kind).bound != Bound::none;
  });
}

template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  Reaction<M> result;
  int place = scene.place(constraint);
  bool took_part = work.version == scene.version();
  if (!took_part && constraint >= 0) {  // others came or went since
    const std::uint64_t stamp = scene.entries()[place].stamp;
    const auto& stamps = work.system.stamp_of;
    const auto at = std::lower_bound(stamps.begin(), stamps.end(), stamp);
    took_part = at != stamps.end() && *at == stamp;
    place = static_cast<int>(at - stamps.begin());
  }
  require(took_part, "constraint", constraint, "one that took part in the last step");
  const int row = work.system.row_of[place];
  work.system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks) {
      if (block.row != row) continue;
      const Rows<K> force = Eigen::Map<const Rows<K>>(&work.system.lambda[row]) / work.h;
      result.force = block.J.l2().transpose() * force;
      if constexpr (M::angular > 0) {
        result.torque1 = block.J.a1().transpose() * force;
        result.torque2 = block.J.a2().transpose() * force;
      }
    }
  });
  return result;
}

#define BYHAND_INSTANTIATE(M)                                     \
  template bool lay_out_naturally(const Scene<M>&, StepWork<M>&); \
  template bool has_bounds(const Scene<M>&);                      \
  template Reaction<M> reaction(const Scene<M>&, const StepWork<M>&, int)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
