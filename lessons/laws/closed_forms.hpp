#pragma once

#include <algorithm>
#include <cmath>
#include <numbers>

// What the laws predict, as far as it is a formula. Lessons that cite a law use these functions and do not wait
// for its experiment. The files beside this one derive the formulas and compare them with runs.
namespace byhand::laws {

/// Law 1 (baumgarte.cpp). C/L at which a spinning rod settles: (ωh)²/2β, with turn = ωh [rad] small and β in (0,
/// 2).
inline double stretch_of_a_spinning_rod(double turn, double beta) { return turn * turn / (2 * beta); }

/// Law 2 (pop.cpp). The overlap [m] above which a contact that is corrected by β in (0, 1] throws its body off the
/// ground: the least over whole numbers n > 1/β of steps of gh² n(n − 1)/2(nβ − 1). It is at most (1 − β/2)
/// 2gh²/β², which it is where 2/β is whole.
inline double popping_overlap(double beta, double step, double gravity = 9.81) {
  double least = INFINITY;
  for (double n = std::floor(1 / beta) + 1; n <= 2 / beta + 1; ++n)
    if (n * beta > 1) least = std::min(least, n * (n - 1) / (2 * (n * beta - 1)));
  return gravity * step * step * least;
}

/// Law 3 (baumgarte.cpp). The radius [m] of a circle after a time [s] without drift cure, begun at a speed [m/s]
/// on another radius [m]: R (1 + 2v²ht/R²)^¼, for vh up to R/2.
inline double drifted_radius(double radius, double speed, double step, double time) {
  return radius * std::pow(1 + 2 * step * speed * speed * time / (radius * radius), 0.25);
}

/// Law 4 (sweeps.cpp). The share of its error that k sweeps of Gauss–Seidel leave of the j-th slowest wave on a
/// straight chain of N equal links with one end anchored, or of the weights in a column of N boxes: cos²ᵏ((2j −
/// 1)π/2N), 2j − 1 <= N. D. M. Young, "Iterative Methods for Solving Large Linear Systems", 1971.
inline double left_by_sweeps(int links, double sweeps, int wave = 1) {
  return std::pow(std::cos((2 * wave - 1) * std::numbers::pi / (2 * links)), 2 * sweeps);
}
inline double left_by_a_sweep(int links) { return left_by_sweeps(links, 1); }

/// Law 4 (sweeps.cpp). The same of one sweep under an end that is `ratio` times as heavy as a bob: r/(1 + r) for
/// two links, to first order in 1/r 1 − 1/(r(N − 1)) for more.
inline double left_above_a_heavy_end(int links, double ratio) {
  return links == 2 ? ratio / (1 + ratio) : 1 - 1 / (ratio * (links - 1));
}

/// Law 6 (warm_start.cpp). The largest β per step at which all errors of rods die out, if each step starts warm
/// and its sweeps leave the share q > 0 of the slowest: min((1 − q)/q, 2).
inline double largest_beta(double q) { return std::min((1 - q) / q, 2.0); }

/// Width and height of the boxes of a column [m].
struct BoxSize {
  double width = 1, height = 1;
};

/// Law 18 (creep.cpp). The share of the slowest bending of a column of N boxes of width w and height a that a
/// sweep leaves, face by face: 1 − 1.03 (1 + w²/a²)/N⁴, compared with runs from N = 8 on.
inline constexpr double cantilever = 12.362;  // eigenvalue of its slowest bending: 1.8751⁴, cos x cosh x = −1
inline double bending_left_by_a_sweep(int boxes, const BoxSize& size = {}) {
  const double slender = size.width / size.height;
  return 1 - cantilever * (1 + slender * slender) / (12 * std::pow(boxes, 4));
}

/// Law 18 (creep.cpp). σ² at which a column of N boxes tips over by itself: 1.571 g/Na [1/s²].
inline double tipping_rate_squared(int boxes, double gravity, const BoxSize& size = {}) {
  return 1.571 * gravity / (boxes * size.height);
}

/// Law 18 (creep.cpp). The sweeps k from which a column stands that tips at σ and of whose bending a sweep leaves
/// ρ: (σh)² = (1 − ρᵏ)/ρᵏ.
inline double sweeps_to_stand(double tipping_rate_squared, double left_by_a_sweep, double step) {
  return std::log1p(tipping_rate_squared * step * step) / -std::log(left_by_a_sweep);
}
inline double sweeps_to_stand(int boxes, double gravity, double step, const BoxSize& size = {}) {
  return sweeps_to_stand(tipping_rate_squared(boxes, gravity, size), bending_left_by_a_sweep(boxes, size), step);
}

/// Law 21 (doubling.cpp). By how much one step and its two halves differ for an error C [m] that is corrected by β
/// per step, whatever the step [m].
inline double difference_of_a_doubled_step(double beta, double error) { return beta * (1 - beta) * error; }

}  // namespace byhand::laws
