#pragma once

#include "lessons/methods/positions.hpp"

// Augmented vertex block descent. A step of implicit Euler finds the poses x that minimise
//
//   ½ |x - y|²_M + Σ ½ κ C²,    y = x₀ + h (v₀ + h g),   κ = h² k,
//
// with the free motion y and a stiffness k of each row. Body after body takes a Newton step while the others stay:
//
//   (M + Σ (Jᵀ κ J + G)) Δx = -M (x - y) + Σ Jᵀ F,      F = Λ - κ C within bounds
//
// G stands for F times the second derivatives of C, which are differences of J taken once a step: the length of
// each column, on the diagonal, so that the matrix stays positive definite. G holds the sideways stiffness of a
// chain under tension: without it 50 links with an end mass of 1000 come apart by metres.
//
// A hard row's Λ is the multiplier of the augmented Lagrangian. After each round over the bodies
//
//   Λ ← Λ - κ C within bounds,    k ← k + β|C| m/h² while F is inside them,
//
// so that C vanishes although κ stays finite; m is the row's effective mass (the paper's β is in N/m², and what is
// heavy or slow needs another). From step to step k is scaled by a memory below 1 (the paper's γ)
// and Λ by that and α. A hard row removes only the share 1 - α of its error C₀ at the start of a step, or the
// correction would become speed; an open contact may close. A soft row (a spring, a softness) has the k of its
// material, 1/(h²γ), and F = -κ C. (The paper lets that k grow as well; then 2 kg on 1e5 N/m sag 2.3 times as far
// for β = 1e5.)
//
// Rounds start from x₀ + h v₀, not from y: a body at rest is there already. Rows without a C have C - C₀ + h rate,
// as in positions.hpp. Linear momentum is kept only as far as the rounds converge.
//
// Source: C. Giles, E. Diaz, C. Yuksel, Augmented vertex block descent, ACM Trans. Graph. 44(4), 2025.
namespace byhand {

/// AVBD, as choices. Cost of a step: iterations × (rows at each of their moving bodies + rows once more for Λ).
struct Avbd {
  /// `stiffness` of the system is k [N/m].
  template <class M>
  struct Work : PositionWork<M> {
    struct Holder {
      int body, run, block;  // the constraint by its run and the index of its block
      bool second;           // whether `body` is its second
    };
    std::vector<Holder> holders;    // the constraints of each moving body, sorted by body
    std::vector<double> curvature;  // how fast J of each row changes with each of its 2 dof coordinates
    std::vector<double> unit;       // of each row's k: its effective mass over h² [N/m]
  };

  int iterations = 10;    // >= 1
  double alpha = 0.95;    // share of a hard row's C₀ that stays, in [0, 1]
  double beta = 100;      // growth of k in the row's unit per unit of C [1/m] >= 0; with 300 piles explode
  double memory = 0.99;   // share of k, and with α of Λ, kept from step to step, in [0, 1]
  double softest = 1;     // smallest k of a hard row, in the row's unit > 0
  double stiffest = 3e5;  // largest > 0
  Gyroscopic gyroscopic = Gyroscopic::implicit;  // of bodies in space
  double bounce_threshold = 0.5;                 // slower contacts do not bounce [m/s] >= 0
};

void require_valid(const Avbd& method);
template <class M>
void advance(Scene<M>& scene, const Avbd& method, double h, Avbd::Work<M>& work);

}  // namespace byhand
