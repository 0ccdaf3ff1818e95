#include "lessons/laws/warm_start.hpp"

#include <fmt/format.h>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/laws/record.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/step.hpp"

// Law 6. Let k sweeps leave q = ρᵏ of what the slowest mode of λ lacks, and write a for that mode of JM⁻¹Jᵀ, v for
// its rate and C for its error, both measured from rest, so that gravity drops out. The exact λ* would give v +
// aλ* = -βC/h; begun with the last λ, sweeps give λ' = λ* + q(λ - λ*), and since aλ is what v has just changed by,
//
//   v(n) = 2q v(n-1) - q v(n-2) - (1 - q) β C(n)/h,      C(n+1) = C(n) + h v(n)
//
// The correction is in λ and is paid again in the next step: the 2q. With zⁿ this is
//
//   z³ - [1 + 2q - (1 - q)β] z² + 3q z - q = 0
//
// At β = (1 - q)/q one root is z = q. The product of all three is q, so the other two have the product 1 and the
// sum 3 - 1/q: for q > 1/5 they are complex and lie on the unit circle. Beyond, the slow mode rings. The fast
// modes have q = 0 and law 1's limit of 2, which is the smaller one for q < 1/3.
//
// Derived for this course; nobody seems to have printed it.
namespace byhand::laws {

Outcome run(const WarmChain& chain) {
  using M = PlaneParticle;
  const double size = 1e-7;
  VelocityStepping method{
      GaussSeidel{.sweeps = chain.sweeps, .warm_start = chain.warm_start, .order = chain.order},
      Baumgarte{chain.beta}};
  if (chain.sweeps == 0) method.solver = Direct{};
  method.substeps = chain.substeps;
  Simulation<M> simulation{rod_chain<M, NormalisedDistance>({.links = chain.links}), method};
  simulation.scene.gravity.setZero();
  const auto& pose = simulation.scene.bodies().pose;
  for (int i = 1; i <= chain.links; ++i)
    simulation.scene.set_position(i, {pose[i].position.x(), pose[i].position.y() + size * uneven(i)});
  Record record(size, 0.5);
  for (int i = 0; i < chain.steps; ++i) {
    simulation.step(1.0 / 60);
    if (!record.note(pose[chain.links].position.y() + chain.links)) break;
  }
  return record.outcome();
}

Law warm_start() {
  Law law{6,
          Family::overshooting_correction,
          "warm start with Baumgarte",
          "a warm start repeats the last step's correction; if the sweeps cannot remove it, the error rings",
          "β < min(2, (1 − q)/q), q = cos²ᵏ(π/2N)",
          {}};
  struct Setting {
    int links, sweeps;
  };
  for (const auto& [links, sweeps] :
       {Setting{5, 1}, {5, 4}, {10, 1}, {10, 4}, {10, 10}, {10, 30}, {20, 10}, {20, 30}}) {
    const WarmChain chain{.links = links, .sweeps = sweeps};
    const double law_says = largest_beta(left_by_sweeps(links, sweeps));
    law.boundaries.push_back(bisected({"β",
                                       "",
                                       fmt::format("{} links, {}", links, counted(sweeps, "sweep")),
                                       law_says,
                                       0.02,
                                       {},
                                       settles(chain, &WarmChain::beta, run)}));
  }
  return law;
}

}  // namespace byhand::laws
