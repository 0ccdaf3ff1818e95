#pragma once

#include "solver/integrate/gyroscopic.hpp"
#include "solver/methods/positions.hpp"

// Augmented vertex block descent. A step of implicit Euler is a minimum: of all poses x the new ones make
//
//   ½ |x - y|²_M + Σ ½ κ C²,    y = x₀ + h (v₀ + h g),   κ = h² k,
//
// smallest, y being where the bodies would go by themselves and k the stiffness of each row. The method goes from
// body to body and lets each take a Newton step while the others stand still, with its own dof × dof matrix:
//
//   (M + Σ (Jᵀ κ J + G)) Δx = -M (x - y) + Σ Jᵀ F,      F = Λ - κ C within bounds
//
// G stands for the second derivatives of C times F, of which a column's length is put on the diagonal so that the
// matrix stays definite. It is not a refinement: a chain under tension is stiff sideways, and without G one of 50
// links with an end mass of 1000 comes apart by metres. C's second derivatives are differences of J, taken once a
// step.
//
// A hard row has no finite k: Λ is its multiplier, the augmented Lagrangian's, and after each round over the
// bodies
//
//   Λ ← Λ - κ C within bounds,    k ← k + β|C| while F is inside them,
//
// so that C vanishes though κ stays finite. From one step to the next k is scaled by a memory below 1 (the
// paper's γ) and Λ by that and α. Of the error C₀ that a hard row has at the beginning of a step it removes the
// share 1 - α, or the push would become speed; a contact still open may close. A row that gives way (a spring, a
// softness) has the k of its material, 1/(h²γ) with the γ of its row, and F = -κ C. (The paper lets that k grow
// too, from little and forgetting some in each step; then a stiff spring gives way by more than its k says: 2.3
// times where 2 kg hang on 1e5 N/m and β is 1e5.)
//
// The rounds set out from x₀ + h v₀, not from y: what rests is then where it belongs. Rows are those of
// positions.hpp, with C - C₀ + h rate for C where they have none; a spring's damping, a motor's speed and
// friction's ball come with that, and a bounce. Bodies that are solved one after the other do not push each other
// equally until the rounds have converged, so even linear momentum is kept only so far.
//
// (Source: C. Giles, E. Diaz, C. Yuksel, Augmented vertex block descent, ACM Trans. Graph. 44(4), 2025.)
namespace byhand {

/// AVBD, as choices. Cost of a step: iterations × (rows at each of their moving bodies + rows once more for Λ).
struct Avbd {
  template <class M>
  struct Work;

  int iterations = 10;    // >= 1
  double alpha = 0.95;    // of a hard row's error at the beginning of a step this share stays, in [0, 1]
  double beta = 1e6;      // k's growth for each unit of C [N/m²] >= 0
  double memory = 0.99;   // what is kept of k, and with α of Λ, from step to step, in [0, 1]
  double softest = 1;     // k of a new row, and at least, in units of its effective mass over h² > 0
  double stiffest = 1e9;  // k at most [N/m] > 0
  Gyroscopic gyroscopic = Gyroscopic::none;  // of bodies in space
  double bounce_threshold = 0.5;             // slower than this nothing bounces [m/s] >= 0
};

/// Throws std::invalid_argument for a choice outside its range.
void require_valid(const Avbd& method);

/// Why this scene cannot be run so: it always can.
template <class M>
std::string refusal(const Scene<M>&, const Avbd&) {
  return {};
}

/// What is kept between steps: Λ and k (the system's stiffness [N/m]), which constraints hold which body, and
/// scratch.
template <class M>
struct Avbd::Work : PositionWork<M> {
  struct Holder {
    int type, block, kind, row;  // of a constraint's block
    bool second;                 // whether the body is its second
  };

  std::vector<double> curvature;  // how fast J of each row changes with each of its 2 dof coordinates
  std::vector<int> first;         // body i's holders begin at holders[first[i]]
  std::vector<Holder> holders;
  std::vector<Pose<M>> free;  // y
};

/// One time step [s]. Throws std::invalid_argument for a step <= 0 or a method outside its range.
template <class M>
void advance(Scene<M>& scene, const Avbd& method, double h, Avbd::Work<M>& work);

}  // namespace byhand
