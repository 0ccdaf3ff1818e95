#include "solver/step_work.hpp"

namespace byhand {

std::vector<int> solve_order(Layout layout, const Graph& graph, int dof, Elimination& plan) {
  if (layout == Layout::coloured) return coloured_order(graph);
  if (layout == Layout::elimination) {
    const long long most = most_multiplications(graph);
    plan = plan_elimination(graph, dof, most);
    if (plan.multiplications > most)
      throw std::invalid_argument(
          "a direct solve of these " + std::to_string(graph.edges.size()) + " constraints would take more than " +
          std::to_string(most) + " multiplications a step, so many loops do they make; conjugate sweeps would do");
    return plan.order;
  }
  std::vector<int> order(graph.edges.size());
  std::iota(order.begin(), order.end(), 0);
  if (layout == Layout::reverse) std::reverse(order.begin(), order.end());
  return order;
}

template <class M>
void refuse_not_finite(const Scene<M>& scene, const State<M>& came) {
  require_finite<M>(scene.bodies().pose, scene.bodies().velocity, "");
  for (const auto& entry : scene.entries()) {
    const ConstraintStore<M>& store = scene.store(entry.kind);
    double C[6];  // no block has more rows
    store.write_value(entry.index, scene.bodies(), C);
    if (!std::all_of(C, C + store.rows, [](double c) { return std::isfinite(c); }))
      throw NotFinite("constraint " + std::to_string(entry.id) + " has a value that is not a finite number");
  }
  require_finite<M>(came.pose, came.velocity, " after a step, which was taken back");
}

template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint) {
  Reaction<M> result;
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
  const int row = work.system.row_of[place];
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

BYHAND_DEFINE_COPIES(StepWork)

#define BYHAND_INSTANTIATE(M)                                        \
  template struct StepWork<M>;                                       \
  template void refuse_not_finite(const Scene<M>&, const State<M>&); \
  template Reaction<M> reaction(const Scene<M>&, const StepWork<M>&, int)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
