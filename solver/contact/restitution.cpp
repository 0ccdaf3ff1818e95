#include "solver/contact/restitution.hpp"

#include "solver/gauss_seidel.hpp"

namespace byhand {
namespace {

/// Calls f(row, e) for each row that met faster than `threshold`.
template <class M, class F>
void for_each_bounce(const std::vector<double>& approach, double threshold, const System<M>& system, F&& f) {
  if (approach.empty()) return;
  system.for_each_run([&]<int K, Bound B>(std::span<const Block<M, K, B>> blocks) {
    for (const auto& block : blocks)
      for (int k = 0; k < bouncing<K, B>; ++k)
        if (system.restitution[block.row] > 0 && approach[block.row + k] < -threshold)
          f(block.row + k, system.restitution[block.row]);
  });
}

}  // namespace

template <class M>
void note_approach(const System<M>& system, const std::vector<Velocity<M>>& velocities,
                   std::vector<double>& approach) {
  approach.clear();
  if (!system.bounded || std::ranges::all_of(system.restitution, [](double e) { return e == 0; })) return;
  approach.resize(system.rows());
  rates_of(system, velocities, approach);
}

//! [bounce]
template <class M>
bool set_bounce(const std::vector<double>& approach, double threshold, System<M>& system) {
  bool any = false;
  for_each_bounce(approach, threshold, system, [&](int row, double e) {
    if (system.lambda[row] <= 0) return;
    system.bias[row] = e * approach[row];
    any = true;
  });
  return any;
}
//! [bounce]

template <class M>
void forget_bounce(const std::vector<double>& approach, double threshold, System<M>& system) {
  for_each_bounce(approach, threshold, system, [&](int row, double) { system.lambda[row] = 0; });
}

#define BYHAND_INSTANTIATE(M)                                                                           \
  template void note_approach(const System<M>&, const std::vector<Velocity<M>>&, std::vector<double>&); \
  template bool set_bounce(const std::vector<double>&, double, System<M>&);                             \
  template void forget_bounce(const std::vector<double>&, double, System<M>&)
BYHAND_FOR_EACH_MODEL(BYHAND_INSTANTIATE);
#undef BYHAND_INSTANTIATE

}  // namespace byhand
