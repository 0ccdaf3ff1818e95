#include "lessons/laws/sweeps.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/scenes/box_on_contacts.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/measure.hpp"

// Law 4. On a straight chain row i shares a bob with its neighbours: JM⁻¹Jᵀ is (-1, 2, -1), with 1 in the corner
// where an anchor moves nothing. Its Jacobi matrix has the largest eigenvalue cos(π/2N) when anchored, cos(π/(N +
// 1)) when free, and of what couples neighbours only Gauss–Seidel leaves the square of what Jacobi leaves (D. M.
// Young, "Iterative Methods for Solving Large Linear Systems", 1971). So one more digit costs ln 10/-ln cos²(π/2N)
// = 0.933 N² sweeps. A heavy end, r times a bob, is a nearly fixed one from below: 1 - ρ = 1/(r(N - 1)) to first
// order in 1/r; of two bodies exactly ρ = r/(1 + r). With ω = 2/(1 + √(1 - ρ)) of SOR the slowest modes leave ω
// - 1.
//
// Law 5. Jacobi adds up what every row by itself thinks is missing. It converges iff the largest eigenvalue of
// relaxation × D⁻¹A is below 2. Contacts at x_i under a unit box (m = 1 kg, I = m/6) have A_ij = 1 + 6 x_i x_j, of
// rank two and with one even and one odd eigenvector: Σ 1/(1 + 6x²) and Σ 6x²/(1 + 6x²).
namespace byhand::laws {
namespace {

double digits_to_sweeps(double rate) { return -std::log(10) / std::log(rate); }

}  // namespace

Scene<PlaneParticle> scene_of(const SweptChain& chain) {
  using M = PlaneParticle;
  auto scene = rod_chain<M, NormalisedDistance>({.links = chain.links, .end_mass = chain.end_mass});
  scene.gravity.setZero();
  if (!chain.anchored) scene.set_mass(0, with_mass<M>(1));
  for (int i = chain.anchored ? 1 : 0; i <= chain.links; ++i) scene.set_velocity(i, {0, uneven(i + 1)});
  return scene;
}

double left_by_a_sweep(const SweptChain& chain) {
  const GaussSeidel one_sweep{
      .sweeps = 1, .warm_start = false, .order = chain.order, .relaxation = chain.relaxation};
  return left_by_a_sweep(scene_of(chain), one_sweep, 40 + chain.links * chain.links, 50);
}

double largest_eigenvalue(int contacts) {
  double even = 0, odd = 0;
  for (int i = 0; i < contacts; ++i) {
    const double x = static_cast<double>(i) / (contacts - 1) - 0.5, turns = 6 * x * x;
    even += 1 / (1 + turns);
    odd += turns / (1 + turns);
  }
  return std::max(even, odd);
}

Outcome jacobi(int contacts, double relaxation) {
  if (relaxation >= 2) return Outcome::explodes;  // as a single row does
  Simulation<PlaneBody> simulation{box_on_contacts(contacts),
                                   {Jacobi{.sweeps = 2000, .relaxation = relaxation}, NoDriftCure{}}};
  simulation.scene.set_velocity(1, {0, 0, 0.01});  // or the odd eigenvector would not be met
  const double h = 1.0 / 60;
  simulation.step(h);
  const double left = residual(simulation.work.system, simulation.scene.bodies().velocity) / (9.81 * h);
  return left < 1e-4 ? Outcome::settles : Outcome::explodes;
}

Law slow_sweeps() {
  Law law{4,
          Family::too_few_iterations,
          "rate of Gauss–Seidel",
          "a sweep passes an error on to neighbouring rows only, so a chain needs sweeps in proportion to N²",
          "0.933 N² sweeps a digit on an anchored chain",
          {}};
  const auto add = [&](std::string setting, double rate, const SweptChain& chain, double tolerance) {
    law.boundaries.push_back({"sweeps for a digit", "", std::move(setting), digits_to_sweeps(rate), tolerance,
                              [chain] { return digits_to_sweeps(left_by_a_sweep(chain)); }});
  };
  for (const int links : {3, 10, 30, 60})
    add(fmt::format("{} links, anchored", links), left_by_a_sweep(links), {.links = links}, 0.01);
  for (const int links : {10, 30})
    add(fmt::format("{} links, free", links), std::pow(std::cos(std::numbers::pi / (links + 1)), 2),
        {.links = links, .anchored = false}, 0.01);
  for (const double mass : {10.0, 1000.0})
    add(fmt::format("2 links, end mass {}", mass), left_above_a_heavy_end(2, mass), {.links = 2, .end_mass = mass},
        0.01);
  for (const int links : {5, 10})
    add(fmt::format("{} links, end mass 1000", links), left_above_a_heavy_end(links, 1000),
        {.links = links, .end_mass = 1000}, 0.01);
  for (const int links : {3, 10}) {
    const double best = 2 / (1 + std::sqrt(1 - left_by_a_sweep(links))), beyond = 0.5 * (best + 2);
    add(fmt::format("{} links, SOR with {:.3f}", links, beyond), beyond - 1,
        {.links = links, .relaxation = beyond}, 0.02);
  }
  return law;
}

Law jacobi_overshoots() {
  Law law{5,
          Family::overshooting_correction,
          "relaxation of Jacobi",
          "rows that correct the same error at the same time overcorrect it",
          "relaxation w < 2/μ, μ the largest eigenvalue of D⁻¹A",
          {}};
  for (const int contacts : {2, 3, 4, 6, 8, 12})
    law.boundaries.push_back(
        bisected({"relaxation",
                  "",
                  fmt::format("{} contacts under one box", contacts),
                  2 / largest_eigenvalue(contacts),
                  0.01,
                  {},
                  [=](double relaxation) { return jacobi(contacts, relaxation) == Outcome::settles; }}));
  return law;
}

}  // namespace byhand::laws
