#include "lessons/catalogue/methods.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace byhand {
namespace {

DriftCure cure_of(const Knobs& knobs) {
  switch (knobs.cure) {
    case Cure::none: return NoDriftCure{};
    case Cure::baumgarte: return Baumgarte{knobs.strength};
    case Cure::split_impulse: return SplitImpulse{knobs.strength};
    case Cure::soft: return SoftConstraints{.frequency = knobs.strength * knobs.substeps / frame};
    case Cure::projection: return Projection{static_cast<int>(std::lround(knobs.strength))};
  }
  return NoDriftCure{};
}

const std::vector<Cure> all_cures{Cure::baumgarte, Cure::projection, Cure::split_impulse, Cure::soft, Cure::none};

/// Rows solved by `solver(knobs)` in each substep.
template <class Solver>
Family by_rows(const char* name, const char* pass, Solver solver) {
  return {.name = name, .pass = pass, .cures = all_cures, .setting = [=](const Knobs& knobs) {
            AnyStepping method{solver(knobs), cure_of(knobs)};
            method.substeps = knobs.substeps;
            method.gyroscopic = Gyroscopic::implicit;
            return Setting{method};
          }};
}

/// A method with substeps and its own way to hold C.
template <class Choices>
Family by_substeps(const char* name, Choices choices) {
  return {.name = name,
          .pass = "",
          .cures = {Cure::none},
          .solves_rows = false,
          .exact = true,
          .setting = [=](const Knobs& knobs) {
            Choices method = choices;
            method.substeps = knobs.substeps;
            return Setting{method};
          }};
}

std::vector<Family> make_families() {
  Family sweeps = by_rows("Gauss–Seidel", "sweep", [](const Knobs& k) {
    return GaussSeidel{.sweeps = k.passes, .relaxation = k.relaxation};
  });
  Family symmetric = by_rows("symmetric Gauss–Seidel", "sweep", [](const Knobs& k) {
    return GaussSeidel{.sweeps = k.passes, .order = SweepOrder::symmetric, .relaxation = k.relaxation};
  });
  sweeps.most_relaxation = symmetric.most_relaxation = 1.95;
  Family jacobi = by_rows("Jacobi", "sweep",
                          [](const Knobs& k) { return Jacobi{.sweeps = k.passes, .relaxation = k.relaxation}; });
  jacobi.least_relaxation = 0.1;
  Family direct = by_rows("direct", "", [](const Knobs& k) { return Direct{.regularisation = k.regularisation}; });
  direct.exact = true;
  Family xpbd = by_substeps("XPBD", Xpbd{.gyroscopic = Gyroscopic::implicit});
  xpbd.pass = "iteration";
  xpbd.exact = false;
  xpbd.setting = [](const Knobs& k) {
    return Setting{Xpbd{.substeps = k.substeps, .iterations = k.passes, .gyroscopic = Gyroscopic::implicit}};
  };
  Family avbd = xpbd;
  avbd.name = "AVBD";
  avbd.cures = {Cure::baumgarte};  // its 1 - α is a share of C that a step takes back
  avbd.setting = [](const Knobs& k) {
    return Setting{
        Avbd{.iterations = k.passes, .alpha = 1 - std::min(1.0, k.strength), .gyroscopic = Gyroscopic::implicit},
        k.substeps};
  };

  return {
      sweeps,
      symmetric,
      jacobi,
      by_rows("conjugate sweeps", "sweep",
              [](const Knobs& k) { return ConjugateSweeps{.sweeps = k.passes, .tolerance = 0}; }),
      by_rows("conjugate sweeps to a tolerance", "digit",
              [](const Knobs& k) {
                return ConjugateSweeps{.sweeps = 1000, .tolerance = std::pow(10, -std::min(k.passes, 12))};
              }),
      by_rows("conjugate gradients", "iteration",
              [](const Knobs& k) { return ConjugateGradients{.iterations = k.passes, .tolerance = 0}; }),
      by_rows("accelerated gradient", "iteration",
              [](const Knobs& k) { return AcceleratedGradient{.iterations = k.passes, .tolerance = 0}; }),
      direct,
      by_substeps("RATTLE", Rattle{}),
      by_substeps("implicit midpoint", Accelerations{Scheme::implicit_midpoint}),
      by_substeps("RK4", Accelerations{Scheme::rk4}),
      by_substeps("explicit Euler", Accelerations{Scheme::explicit_euler}),
      by_substeps("generalised RK4", Generalised{}),
      by_substeps("generalised Euler", Generalised{JointRule::semi_implicit_euler}),
      xpbd,
      avbd,
  };
}

}  // namespace

const std::vector<Family>& families() {
  static const std::vector<Family> all = make_families();
  return all;
}

const Family& family_named(std::string_view name) {
  for (const Family& family : families())
    if (family.name == name) return family;
  std::string names;
  for (const Family& family : families()) names += (names.empty() ? "" : ", ") + family.name;
  require(false, "method", name, "one of " + names);
  return families().front();
}

Prices prices_of(std::string_view kind, const Family& family, Cure cure) {
  const Prices own = prices_of(kind, family.name);
  return family.solves_rows ? own + prices_of(kind, "stepping") + prices_of(kind, name_of(cure)) : own;
}

std::string_view name_of(Cure cure) {
  switch (cure) {
    case Cure::none: return "none";
    case Cure::baumgarte: return "Baumgarte";
    case Cure::split_impulse: return "split impulse";
    case Cure::soft: return "soft constraints";
    case Cure::projection: return "projection";
  }
  return "";
}

std::string_view symbol_of(Cure cure) {
  return cure == Cure::none ? "" : cure == Cure::soft ? "ωh" : cure == Cure::projection ? "sweeps" : "β";
}

std::string described_knobs(const Family& family, const Knobs& knobs) {
  std::string text = fmt::format(", {} substep{}", knobs.substeps, knobs.substeps == 1 ? "" : "s");
  if (!family.pass.empty())
    text += fmt::format(", {} {}{}", knobs.passes, family.pass, knobs.passes == 1 ? "" : "s");
  if (knobs.relaxation != 1) text += fmt::format(", ω = {:.3g}", knobs.relaxation);
  if (knobs.cure == Cure::baumgarte) text += fmt::format(", β = {:.3g}", knobs.strength);
  if (knobs.cure == Cure::split_impulse) text += fmt::format(", split impulse with β = {:.3g}", knobs.strength);
  if (knobs.cure == Cure::soft) text += fmt::format(", soft constraints with ωh = {:.3g}", knobs.strength);
  if (knobs.cure == Cure::projection)
    text += fmt::format(", projection by {:.0f} sweep{}", knobs.strength, knobs.strength == 1 ? "" : "s");
  if (knobs.regularisation > 0) {  // 1e-9, not 1e-09
    const double exponent = std::floor(std::log10(knobs.regularisation) + 1e-9);
    text += fmt::format(", regularised by {:.2g}e{}", knobs.regularisation / std::pow(10, exponent), exponent);
  }
  return text;
}

Knobs with_cure(Knobs knobs, Cure cure) {
  knobs.cure = cure;
  knobs.strength = cure == Cure::none ? 0 : cure == Cure::baumgarte ? 0.2 : cure == Cure::soft ? 0.4 : 1;
  return knobs;
}

}  // namespace byhand
