#include "lessons/catalogue/limits.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <numbers>

#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/creep.hpp"
#include "lessons/laws/transverse.hpp"

namespace byhand {
namespace {

int links_of(const Problem& problem) {
  const std::string& name = problem.scene().name;
  if (name == "chain") return static_cast<int>(problem["links"]);
  return name == "double_pendulum" ? 2 : name == "pendulum" || name == "compound_pendulum" ? 1 : 0;
}

/// Where T h²/(m l) of law 7 ends: rods that are pinned to each other swing faster than bobs.
double limit_of_taut(const Problem& problem) {
  const bool rods = problem.model().starts_with("links") && links_of(problem) != 1;
  return rods ? laws::limit_of_rods : laws::limit_of_bobs;
}

/// T h²/(m l) of law 7 at one step a frame, over its limit. What is let go from an angle θ passes its lowest point
/// under the pull (3 - 2cos θ) times its weight.
double pull_over_stiffness(const Problem& problem) {
  const std::string& name = problem.scene().name;
  if (problem.scene().duty != Duty::hold || name == "top") return 0;
  const double turned = std::cos(problem["angle"] * (std::numbers::pi / 180)), h2 = frame * frame;
  const double swing = name == "conical_pendulum" ? 1 / turned : 3 - 2 * turned;
  double hanging = problem["mass"];  // on the topmost link
  if (const int links = links_of(problem); links > 1)
    hanging = (links - 1) * problem["mass"] + problem["end_mass"];
  if (name == "four_bar") hanging += problem["coupler_mass"] / 2;
  double pull = swing * problem["gravity"] * hanging;
  if (name == "spherical_pendulum")
    pull += problem["mass"] * problem["length"] * std::pow(problem["azimuth_rate"], 2);
  return pull * h2 / (problem["mass"] * problem["length"]) / limit_of_taut(problem);
}

}  // namespace

int substeps_of_law_7(const Problem& problem) {
  return std::max(1, static_cast<int>(std::ceil(std::sqrt(pull_over_stiffness(problem)))));
}

LawLimit limit_of(const Problem& problem) {
  const std::string& name = problem.scene().name;
  LawLimit limit;
  if (const double number = pull_over_stiffness(problem); number > 0) {
    limit.law = 7;
    limit.number = fmt::format("{}T·h²/(m·l) = {:.2g}", limit_of_taut(problem) < 1 ? "3·" : "", number);
    limit.substeps = substeps_of_law_7(problem);
  } else if (name == "stack") {
    const int boxes = static_cast<int>(problem["boxes"]);
    // The law is one of many boxes: where it asks for less than a sweep, one will do.
    const double asked = 0.76 * problem["gravity"] * frame * frame * std::pow(boxes, 3);
    while (asked > 1 && limit.sweeps < 1 << 20 &&
           laws::gravity_that_sweeps_hold(boxes, limit.sweeps, frame) < problem["gravity"])
      limit.sweeps += std::max(1, limit.sweeps / 8);
    limit.law = 18;
    limit.number = fmt::format("¾·g·h²·N³/a = {:.2g}", asked);
  } else if (name == "top") {
    limit.law = 13;
    limit.number = fmt::format("ω·h = {:.2g} rad", problem["spin"] * frame);
  }
  return limit;
}

double left_by_a_sweep(const Problem& problem, double relaxation) {
  const int links = links_of(problem);
  if (links == 0) return NAN;
  double rho = laws::left_by_a_sweep(links);
  if (links > 1) {
    const double r = problem["end_mass"] / problem["mass"];
    rho = std::max(rho, laws::left_above_a_heavy_end(links, r));
  }
  // Young: of Jacobi's μ = √ρ a relaxation leaves λ with λ + ω - 1 = √λ ωμ.
  const double half = relaxation * std::sqrt(rho) / 2, root = half * half - (relaxation - 1);
  return root <= 0 ? relaxation - 1 : std::pow(half + std::sqrt(root), 2);
}

double largest_beta(const Problem& problem, int sweeps, double relaxation) {
  const double rho = left_by_a_sweep(problem, relaxation);
  return std::isnan(rho) || rho == 0 ? 2 : laws::largest_beta(std::pow(rho, sweeps));
}

}  // namespace byhand
