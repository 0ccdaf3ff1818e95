#pragma once

#include <any>
#include <limits>

#include "solver/system.hpp"

// JV = 0 keeps a constraint's rate at zero, not its value: C drifts. A cure turns C into the bias b of (21), or
// corrects the poses after they have moved, or both. It is a struct of choices: one file of this folder, or of a
// program that uses the library. The step asks of it, where it has them,
//
//   Correction correction(double h) const    the bias of its rows; h is the whole substep. Default: none
//   void begin(Stage<M>&) const              once rows and bias are written, before they are solved
//   void after_move(Stage<M>&) const         once the poses have moved
//   void require_valid(cure)                 throws std::invalid_argument for a choice outside its range
//
// DriftCure in step.hpp lists those of the library. A program gives its own to VelocitySteppingWith.
namespace byhand {

template <class M>
class Scene;
template <class M>
struct StepWork;

/// How a cure sets the bias: b = per_second C.
struct Correction {
  double per_second = 0;  // [1/s]
  // Of one-sided rows only: overlap that is left, so that resting contacts keep touching [m] >= 0, and the largest
  // speed at which the rest is pushed out [m/s] > 0.
  double slop = 0;
  double speed_cap = std::numeric_limits<double>::infinity();
};

inline void require_valid_slop(double slop, double speed_cap) {
  require_in("slop", slop, 0, 1e300, "m");
  require(speed_cap > 0, "speed cap", speed_cap, "above zero [m/s]");
}

/// The step h [s] at which a cure acts: a substep, or a part of one that ends in an impact.
template <class M>
struct Stage {
  Scene<M>& scene;
  StepWork<M>& work;
  double h;
  std::any& kept;  // what the cure keeps between steps

  /// By the step's row solver, from the current λ.
  virtual void solve_rows_again() = 0;

 protected:
  Stage(Scene<M>& s, StepWork<M>& w, double substep, std::any& k) : scene(s), work(w), h(substep), kept(k) {}
  ~Stage() = default;
};

/// The W in `kept`; a new one where it holds nothing or something else.
template <class W>
inline W& kept_as(std::any& kept) {
  W* found = std::any_cast<W>(&kept);
  return found ? *found : kept.emplace<W>();
}

/// Sets b of every row. A one-sided row that is open (C > 0) may close its gap within the step but not more: b =
/// C/h, whatever the cure.
template <class M>
void set_bias(const Correction& correction, double h, System<M>& system) {
  const auto [per_second, slop, speed_cap] = correction;
  for (int i = 0; i < system.rows(); ++i) system.bias[i] = per_second * system.C[i] + system.target_rate[i];
  if (!system.bounded) return;
  for_each_block(system, [&, per_second = per_second, slop = slop, cap = speed_cap]<int K, Bound B>(
                             const Block<M, K, B>& block, const Run&) {
    for (int k = 0; k < K; ++k) {
      if (!one_sided(system, block, k)) continue;
      const double C = system.C[block.row + k];
      const double b = C > 0 ? C / h : std::max(per_second * std::min(C + slop, 0.0), -cap);
      system.bias[block.row + k] = b + system.target_rate[block.row + k];
    }
  });
}

}  // namespace byhand
