#include "lessons/laws/buckling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lessons/laws/column.hpp"
#include "lessons/laws/numbers.hpp"

// Law 17. A contact that is a spring of stiffness k at either end of a face of width w answers a turn θ of the
// face by the moment κθ, κ = kw²/2. To second order in what the boxes lean, θ_1 … θ_N, a column of boxes of height
// a has the energy
//
//   ½κ [base θ_1² + Σ (θ_i - θ_{i-1})²] - ½mga Σ (N - i + ½) θ_i²
//
// and stands while T - (mga/κ) D, from these two sums, has positive pivots only. For many boxes that is
// mga/κ < 7.837/N³, Greenhill's column; N³ < 7.84 kw²/2mga, or a base that sags by at most 1.96 w²/aN². It is a
// matter of statics: neither sweeps nor substeps nor shorter steps help, but stiffness does. All this while the
// base sags by little of a box's height, w < 0.3 Na: flat boxes on contacts as soft as that sink into one another
// first.
//
// Contacts tuned by a frequency have k = m_eff ω² with the row's own effective mass. At a corner of two boxes,
// with I = m(w² + a²)/12, that is m/(2 + 6w²/(w² + a²)), m/5 if they are square, and twice that on the ground:
// base = 2.
//
// A. G. Greenhill, "Determination of the greatest height consistent with stability that a vertical pole or mast
// can be made", Proceedings of the Cambridge Philosophical Society 4, 1881; for contacts derived for this course.
namespace byhand::laws {
namespace {

bool upright(int boxes, double base, double load) {
  double pivot = 1;
  for (int i = 1; i <= boxes; ++i) {
    const double stiffness = (i == 1 ? base : 1) + (i == boxes ? 0 : 1);
    pivot = stiffness - load * (boxes - i + 0.5) - (i == 1 ? 0 : 1 / pivot);
    if (pivot <= 0) return false;
  }
  return true;
}

}  // namespace

double inverse_mass_of_a_corner(const BoxSize& size) {
  const double w2 = size.width * size.width, a2 = size.height * size.height;
  return 2 + 6 * w2 / (w2 + a2);
}

double buckling_load(int boxes, double base) {
  return bisect([=](double load) { return upright(boxes, base, load); }, 1e-12, 1e12, 1e-12);
}

double softest_contacts(int boxes, const BoxSize& size) {
  const double w2 = size.width * size.width,
               stiffness = 2 * g * size.height / (w2 * buckling_load(boxes, 2));  // k of 1 kg
  return std::sqrt(inverse_mass_of_a_corner(size) * stiffness) / (2 * std::numbers::pi);
}

Law buckling() {
  Law law{17,
          Family::too_soft,
          "buckling of soft contacts",
          "a column on soft contacts buckles under its own weight; sweeps and substeps do not move the limit",
          "N³ < 7.84 k w²/2mga, k = m_eff ω²: m_eff = m/5 of squares, a their height",
          {}};
  struct Setting {
    int boxes;
    BoxSize size;
    int substeps;
  };
  for (const auto& [boxes, size, substeps] : {Setting{8, {}, 1},
                                              {8, {}, 4},
                                              {14, {}, 1},
                                              {22, {}, 1},
                                              {30, {}, 1},
                                              {10, {0.2, 0.2}, 1},
                                              {10, {1, 0.5}, 1},
                                              {12, {0.3, 0.5}, 1}}) {
    const Column column{.boxes = boxes, .size = size, .sweeps = 0, .substeps = substeps, .steps = 3000};
    law.boundaries.push_back(bisected(
        {"longest period of the contacts",
         "s",
         fmt::format("{} boxes of {} m × {} m, {}", boxes, size.width, size.height, counted(substeps, "substep")),
         1 / softest_contacts(boxes, size),
         0.03,
         {},
         [=](double period) {
           Column softened = column;
           softened.frequency = 1 / period;
           return buckle(softened) == Outcome::settles;
         }}));
  }
  for (const double frequency : {30.0, 60.0, 120.0}) {
    const double stiffness = std::pow(2 * std::numbers::pi * frequency, 2) / inverse_mass_of_a_corner({}),
                 tallest = std::cbrt(7.837 * stiffness / (2 * g));
    law.boundaries.push_back(bisected(
        {"boxes", "", fmt::format("contacts of {} Hz", frequency), tallest, 1 / tallest, {}, [=](double boxes) {
           const Column column{.boxes = static_cast<int>(std::lround(boxes)), .sweeps = 0, .frequency = frequency};
           return buckle(column) == Outcome::settles;
         }}));
  }
  return law;
}

}  // namespace byhand::laws
