#pragma once

#include "solver/gauss_seidel.hpp"

// Bodies that approach faster than a threshold part with a share e of their speed:
//
//   JV⁺ = -e JV⁻, that is (21) with b = e JV⁻, for each contact that pressed.
//
// JV⁻ is the rate before the step's impulses, and the rows are solved a second time once the positions have moved:
// an open contact closes its gap first, so that a ball bounces on the ground and not above it. The second
// solve continues from the accumulated λ, so that a contact that opens can take back its whole impulse.
namespace byhand {

/// How many rows of a block, the first, may bounce.
template <int K, Bound B>
constexpr int bouncing = B == Bound::interval ? 1 : normals<K, B>;

/// Sets `approach` to JV of all rows; empties it if no surface bounces.
template <class M>
void note_approach(const System<M>& system, const std::vector<Velocity<M>>& velocities,
                   std::vector<double>& approach) {
  approach.clear();
  if (!system.bounded || std::ranges::all_of(system.restitution, [](double e) { return e == 0; })) return;
  approach.resize(system.rows());
  rates_of(system, velocities, approach);
}

/// Calls f(row, e) for each row that approached faster than `threshold` [m/s].
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

/// Sets the bias of those rows that pressed; returns whether there are any.
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

/// Clears λ of those rows: they part, so that the next step must not start with their impulse.
template <class M>
void forget_bounce(const std::vector<double>& approach, double threshold, System<M>& system) {
  for_each_bounce(approach, threshold, system, [&](int row, double) { system.lambda[row] = 0; });
}

}  // namespace byhand
