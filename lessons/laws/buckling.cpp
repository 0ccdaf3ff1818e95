#include "lessons/laws/buckling.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lessons/laws/column.hpp"
#include "lessons/laws/numbers.hpp"

// Law 17. A contact that is a spring of stiffness k at either end of a face of width w answers a turn θ of the
// face by the moment κθ, κ = kw²/2. To second order in what the boxes lean, θ_1 … θ_N, a column of boxes of unit
// height has the energy
//
//   ½κ [base θ_1² + Σ (θ_i - θ_{i-1})²] - ½mg Σ (N - i + ½) θ_i²
//
// and stands while T - (mg/κ) D, from these two sums, has positive pivots only. For many boxes that is
// mg/κ < 7.837/N³, Greenhill's column; N³ < 7.84 kw²/2mg, or a base that sags by at most 1.96 w²/N². It is a
// matter of statics: neither sweeps nor substeps nor shorter steps help, but stiffness does.
//
// Contacts tuned by a frequency have k = m ω² with the row's own effective mass m, which for unit boxes of 1 kg is
// 1/5 between two of them and 2/5 on the ground: base = 2.
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

double buckling_load(int boxes, double base) {
  return bisect([=](double load) { return upright(boxes, base, load); }, 1e-12, 1e12, 1e-12);
}

double softest_contacts(int boxes) {
  const double stiffness = 2 * g / buckling_load(boxes, 2);  // k of 1 kg and 1 m
  return std::sqrt(5 * stiffness) / (2 * std::numbers::pi);
}

Law buckling() {
  Law law{17,
          Family::too_large_a_step,
          "buckling of soft contacts",
          "a column on soft contacts buckles under its own weight; sweeps and substeps do not move the limit",
          "N³ < 7.84 k w²/(2mg), k = m_eff ω², m_eff = m/5",
          {}};
  struct Setting {
    int boxes, substeps, steps;
  };
  for (const auto& [boxes, substeps, steps] :
       {Setting{8, 1, 3000}, {8, 4, 3000}, {14, 1, 3000}, {22, 1, 3000}, {30, 1, 3000}}) {
    const Column column{.boxes = boxes, .sweeps = 0, .substeps = substeps, .steps = steps};
    law.boundaries.push_back(bisected({"softness of the contacts",
                                       "s",
                                       fmt::format("{} boxes, {}", boxes, counted(substeps, "substep")),
                                       1 / softest_contacts(boxes),
                                       0.03,
                                       {},
                                       [=](double period) {
                                         Column softened = column;
                                         softened.frequency = 1 / period;
                                         return buckle(softened) == Outcome::settles;
                                       }}));
  }
  for (const double frequency : {30.0, 60.0, 120.0}) {
    const double stiffness = std::pow(2 * std::numbers::pi * frequency, 2) / 5,
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
