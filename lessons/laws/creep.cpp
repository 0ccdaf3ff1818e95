#include "lessons/laws/creep.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/column.hpp"

// Law 18. A column that leans by x tips over at x'' = σ²x, where its contacts do not hold it. Let k sweeps leave q
// = ρᵏ of what the bending moments lack. The exact ones would stop it, v + aλ* = 0; from a warm start, with v the
// speed of the lean,
//
//   v(n) = q (2 + σ²h²) v(n-1) - q v(n-2)
//
// since gravity, which last step's λ has stopped, has grown by σ²h² v(n-1) only. z² - q(2 + σ²h²)z + q passes
// through z = 1 at
//
//   (σh)² = (1 - q)/q
//
// which is law 6 with gravity for a β below zero. Below it a push dies out and leaves a small lean; above, it
// grows.
//
// Moments M(x) along a column of boxes of height a and width w bend it as a beam: the rate of what its faces turn
// by is M''''/ma², with M and M' zero at the free top and M'' and M''' zero on the ground, which does not move.
// The slowest mode is a cantilever's, with the eigenvalue 1.8751⁴ = 12.362/N⁴. Of the pair of impulses (1, -1)/√2
// at the ends of a face this makes A = 12.362 w²/2a²N⁴ beside d = w²/I = 12w²/(w² + a²) on the diagonal (in 1/m),
// and a sweep leaves ρ = (1 - A/d)² of it, as Young has it for what couples neighbours only:
//
//   ρ = 1 - 1.03 (1 + w²/a²)/N⁴ face by face, 1 - 2.06/N⁴ for squares; row by row, where d = 5, 1 - 2.47/N⁴
//
// Stretch is a second difference (π²/4N²), bending a fourth. In a cantilever's mode φ gravity tips the column at
// σ² = g ∫(N - x) φ'² / a∫φ² = 1.571 g/Na (a stiff rod about its foot: 1.5). So a column of twice as many boxes
// needs eight times the sweeps, for squares k = 0.76 g h² N³/a, and a step half as long a quarter: small boxes
// need more.
//
// Law 20. An exact solve has q = 0 and holds any column, whatever its friction and its masses. One that is
// regularised, by a share r of the diagonal of JM⁻¹Jᵀ, and goes on from the last λ is one sweep of another kind:
// of a mode with the eigenvalue a of JM⁻¹Jᵀ it leaves q = γ/(a + γ), and the column stands iff (σh)² < a/γ. As
// γ = 5r/m: r < 1.236/(σ²h²N⁴).
//
// Both derived for this course.
namespace byhand::laws {
double gravity_that_sweeps_hold(int boxes, int sweeps, double step, const BoxSize& size) {
  const double q = std::pow(bending_left_by_a_sweep(boxes, size), sweeps);
  return (1 - q) / q / (step * step * tipping_rate_squared(boxes, 1, size));
}

Law creep() {
  Law law{18,
          Family::too_few_iterations,
          "creep of a stack",
          "sweeps remove bending slowly: a column leans faster than they can correct",
          "(σh)² < (1 − q)/q, σ² = 1.571 g/Na, q = (1 − 1.03 (1 + w²/a²)/N⁴)ᵏ: k > 0.76 g h² N³/a of squares",
          {}};
  struct Setting {
    int boxes;
    BoxSize size;
    int sweeps, rate;
  };
  for (const auto& [boxes, size, sweeps, rate] : {Setting{8, {}, 1, 60},
                                                  {8, {}, 4, 60},
                                                  {10, {}, 2, 60},
                                                  {10, {}, 2, 120},
                                                  {10, {}, 8, 30},
                                                  {15, {}, 7, 60},
                                                  {20, {}, 16, 60},
                                                  {12, {0.1, 0.1}, 20, 60},
                                                  {10, {1, 0.5}, 3, 60},
                                                  {10, {0.3, 0.5}, 4, 60}}) {
    Column column{.boxes = boxes, .size = size, .sweeps = sweeps, .step = 1.0 / rate};
    const double left = std::pow(bending_left_by_a_sweep(boxes, size), sweeps);
    column.steps = static_cast<int>(4 / (1 - left)) + 1000;  // the other root of the two is q
    law.boundaries.push_back(bisected({"gravity",
                                       "m/s²",
                                       fmt::format("{} boxes of {} m × {} m, {}, {} Hz", boxes, size.width,
                                                   size.height, counted(sweeps, "sweep"), rate),
                                       gravity_that_sweeps_hold(boxes, sweeps, column.step, size),
                                       0.05,
                                       {},
                                       settles(column, &Column::gravity, lean)}));
  }
  return law;
}

double regularisation_that_holds(int boxes, double step) {
  return cantilever / 10 / (step * step * tipping_rate_squared(boxes, 9.81) * std::pow(boxes, 4));
}

Law exact_columns() {
  Law law{20,
          Family::too_soft,
          "exact solution of a stack",
          "solved exactly, a column stands at any friction; regularisation topples it",
          "r < 1.236/(σ²h²N⁴)",
          {}};
  for (const auto& [boxes, rate] : {std::pair{20, 60}, {25, 60}, {30, 60}}) {
    const Column column{.boxes = boxes, .sweeps = 0, .step = 1.0 / rate, .steps = 4000};
    law.boundaries.push_back(bisected({"regularisation",
                                       "of the diagonal",
                                       fmt::format("{} boxes, {} Hz", boxes, rate),
                                       regularisation_that_holds(boxes, column.step),
                                       0.1,
                                       {},
                                       settles(column, &Column::regularisation, lean)}));
  }
  law.boundaries.push_back(
      {"time to fall with μ = 10⁴", "of that with μ = 0.6", "15 boxes, 4 sweeps", 1, 0.02, [] {
         const auto falls = [](double friction) {
           return time_to_fall({.boxes = 15, .sweeps = 4, .friction = friction}, 30);
         };
         return falls(1e4) / falls(0.6);
       }});
  return law;
}

}  // namespace byhand::laws
