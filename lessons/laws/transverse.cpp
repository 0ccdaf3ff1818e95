#include "lessons/laws/transverse.hpp"

#include <fmt/format.h>

#include <cmath>

#include "lessons/exact/hanging_chain.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/step.hpp"

// Law 7. J is held still over a step, and with it the direction in which the tension T pulls: to the side, a bob
// that is off by x is drawn back by T x/l from where it was. That is an explicit spring, even where every step is
// solved exactly, and symplectic Euler holds one only while ωh < 2:
//
//   z² - (2 - (ωh)²) z + 1 = 0 has both roots on the unit circle iff ωh <= 2
//
// A chain swings at the eigenvalues ω² of the tridiagonal matrix with (T_i + T_{i+1})/(m_i l) on its diagonal and
// T_{i+1}²/(m_i m_{i+1} l²) as the squares beside it. All are below (2/h)² iff (2/h)² - K has positive pivots
// only. A light link between heavy ends has 2T/(ml) by itself, and many of them up to twice that: T h²/(ml) < 1.
// Pinned rods are lighter for it: where each leans against the next, their pins move by x and -x in turns, and a
// pin carries a third of a rod's mass, for the rods turn about their middles. So their ω² goes up to 12T/(ml), and
// T h²/(ml) < 1/3.
//
// The condition for one spring is that of J. C. Simo's and every other text on symplectic Euler; that a solved
// constraint is such a spring sideways was derived for this course.
namespace byhand::laws {
namespace {

bool bears(const TautChain& chain, double end_mass) {
  std::vector<double> masses(chain.links, chain.mass);
  masses.back() = end_mass;
  std::vector<double> tension = hanging_chain_tensions(masses, g);
  tension.push_back(0);
  const double h = chain.step / chain.substeps, limit = 4 / (h * h);
  double pivot = 1, beside = 0;
  for (int i = 0; i < chain.links; ++i) {
    pivot = limit - (tension[i] + tension[i + 1]) / (masses[i] * chain.length) - beside / pivot;
    if (pivot <= 0) return false;
    if (i + 1 == chain.links) break;
    const double stiffness = tension[i + 1] / chain.length;
    beside = stiffness * stiffness / (masses[i] * masses[i + 1]);
  }
  return true;
}

}  // namespace

double heaviest_end(const TautChain& chain) {
  return bisect([&](double end_mass) { return bears(chain, end_mass); }, 1e-9 * chain.mass, 1e9 * chain.mass,
                1e-12);
}

Outcome run(const TautChain& chain) {
  using M = PlaneParticle;
  VelocityStepping method{Direct{}, Baumgarte{chain.beta}};
  if (chain.sweeps > 0) method.solver = GaussSeidel{chain.sweeps};
  method.substeps = chain.substeps;
  Simulation<M> simulation{
      rod_chain<M, NormalisedDistance>(
          {.links = chain.links, .length = chain.length, .mass = chain.mass, .end_mass = chain.end_mass}),
      method};
  const auto& pose = simulation.scene.bodies().pose;
  const double size = 1e-8 * chain.length;
  for (int i = 1; i <= chain.links; ++i)
    simulation.scene.set_position(i, {size * uneven(i), pose[i].position.y()});
  bool grown = false;
  for (int i = 0; i < 1000; ++i) {
    simulation.step(chain.step);
    for (const auto& at : pose) {
      const double x = std::abs(at.position.x());
      if (!(x < 0.5 * chain.length)) return Outcome::explodes;
      grown = grown || x > 1000 * size;
    }
  }
  return grown ? Outcome::rings : Outcome::settles;
}

Law transverse() {
  Law law{7,
          Family::too_large_a_step,
          "transverse instability",
          "sideways a taut chain is an explicit spring, even if each step is solved exactly",
          "ω_max h < 2; a long light chain: T h²/(m l) < 1, of pinned rods 1/3",
          {}};
  const auto add = [&](std::string setting, TautChain chain) {
    law.boundaries.push_back(bisected({"end mass",
                                       "kg",
                                       std::move(setting),
                                       heaviest_end(chain),
                                       0.005,
                                       {},
                                       settles(chain, &TautChain::end_mass, run)}));
  };
  for (const int rate : {30, 60, 120, 240})
    add(fmt::format("6 links of 1 kg and 1 m, {} Hz", rate), {.step = 1.0 / rate});
  add("6 links of 0.1 kg and 1 m, 60 Hz", {.mass = 0.1});
  add("6 links of 1 kg and 0.1 m, 60 Hz", {.length = 0.1});
  add("20 links of 1 kg and 1 m, 60 Hz", {.links = 20});
  add("1 m in 10 links of 0.1 kg, 60 Hz, 4 substeps", {.links = 10, .mass = 0.1, .length = 0.1, .substeps = 4});
  return law;
}

}  // namespace byhand::laws
