#include "lessons/laws/hopping.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/column.hpp"

// Law 19. Law 6's slow mode, v(n) = 2q v(n-1) - q v(n-2) - (1 - q) b, C(n+1) = C(n) + h v(n), has b = βC/h where
// boxes overlap. Where they have parted, a contact may close its gap within the step, and not more: b = C/h, as if
// β were 1. Under gravity they rest at C = 0, in the kink between the two, and what hops about it meets β on one
// side and 1 on the other. No eigenvalue says where that stops to settle, but the recurrence itself does: it has
// no scale, so that one run tells. Its limit is 0.35 to 0.45 of law 6's (1 - q)/q while q > 0.8, all of it at
// q = ½. That is for a column that is put down. Two contacts and more have a kink each, and some disturbances hop
// on below the limit too; above it nothing settles.
//
// Law 9. A box of 1 kg on the ground bears one of mass r: ρ = r/(1 + r), law 4's two bodies. The recurrence says
// for each β at which q it stops to settle, and rᵏ/(1 + r)ᵏ reaches that at an r in proportion to k: 3k at β = 0.2
// (q = 0.73). Heavier ones never settle.
//
// Both derived for this course; the factor and the 3 had been measured before.
namespace byhand::laws {
namespace {

bool comes_to_rest(double q, double beta) {
  double C = -1, v = 0, v_before = 0;
  const int window = 10'000;
  double largest[2] = {};
  for (double& in_window : largest)
    for (int i = 0; i < window; ++i) {
      const double v_next = 2 * q * v - q * v_before - (1 - q) * (C < 0 ? beta * C : C);
      v_before = v;
      v = v_next;
      C += v;
      if (!(std::abs(C) < 1e6)) return false;
      in_window = std::max(in_window, std::abs(C));
    }
  return largest[1] < largest[0];
}

}  // namespace

double largest_beta_of_contacts(double q) {
  return bisect([=](double beta) { return comes_to_rest(q, beta); }, 0.1 * (1 - q) / q, 2 * (1 - q) / q, 1e-4);
}

double heaviest_top(int sweeps, double beta) {
  const auto bears = [=](double mass) {
    return comes_to_rest(std::pow(left_above_a_heavy_end(2, mass), sweeps), beta);
  };
  return bisect(bears, 0.2 * sweeps, 100.0 * sweeps, 1e-4);
}

Law heavy_on_light() {
  Law law{9,
          Family::too_few_iterations,
          "heavy on light",
          "with k warm sweeps a heavy box does not settle on one that is much lighter",
          "M/m < c(β, k), about 3k at β = 0.2 for large k (2.66 at k = 1)",
          {}};
  for (const double beta : {0.1, 0.2, 0.5})
    for (const int sweeps : {1, 2, 4, 8}) {
      const double heaviest = heaviest_top(sweeps, beta);
      law.boundaries.push_back(
          {"heaviest upper box / lower box", "", fmt::format("β {}, {}", beta, counted(sweeps, "sweep")), heaviest,
           0.05, [=] {
             double mass = 1.3 * heaviest;
             while (hop({.boxes = 2, .sweeps = sweeps, .beta = beta, .top_mass = mass, .steps = 10'000}) !=
                    Outcome::settles)
               mass /= 1.01;
             return mass;
           }});
    }
  return law;
}

Law hopping() {
  Law law{19,
          Family::overshooting_correction,
          "warm start of contacts",
          "contacts ring at a smaller β than rods: an open contact closes its gap within one step",
          "β < 0.35 to 0.45 times (1 − q)/q, q = cos²ᵏ(π/2N)",
          {}};
  struct Setting {
    int boxes, sweeps;
  };
  for (const auto& [boxes, sweeps] : {Setting{3, 1}, {3, 2}, {5, 1}, {5, 2}, {5, 4}, {10, 4}, {10, 10}}) {
    Column column{.boxes = boxes, .sweeps = sweeps, .steps = 10'000};
    law.boundaries.push_back(bisected({"β",
                                       "",
                                       fmt::format("{} boxes, {}", boxes, counted(sweeps, "sweep")),
                                       largest_beta_of_contacts(left_by_sweeps(boxes, sweeps)),
                                       0.04,
                                       {},
                                       settles(column, &Column::beta, hop)}));
  }
  return law;
}

}  // namespace byhand::laws
