#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "lessons/catalogue/catalogue.hpp"
#include "lessons/catalogue/cost.hpp"

// All ways that the solver knows to go about a scene, and what can be chosen of each.
namespace byhand {

/// Cures of drift.
enum class Cure { none, baumgarte, split_impulse, soft, projection };

/// What can be chosen of a method. What it does not have stays as it is here.
struct Knobs {
  int substeps = 1;           // of a frame
  int passes = 1;             // of each substep: sweeps, iterations, digits
  Cure cure = Cure::none;     // of drift
  double strength = 0;        // of the cure: β; ωh of soft constraints; sweeps of a projection
  double relaxation = 1;      // ω
  double regularisation = 0;  // of a direct solve

  auto operator<=>(const Knobs&) const = default;
};

/// A method with all its choices, and into how many steps of it a frame is cut.
struct Setting {
  Method method;
  int steps = 1;
};

struct Family {
  std::string name;         // "Gauss–Seidel"
  std::string pass;         // "sweep"; empty: none to choose
  std::vector<Cure> cures;  // that it may have; the first is `none` where it has none to choose
  double least_relaxation = 1, most_relaxation = 1;
  bool solves_rows = true;  // for velocities, so that laws 6 and 18 are about it
  bool exact = false;       // whether each solve is exact, so that neither law limits it
  std::function<Setting(const Knobs&)> setting;
};

/// All of them.
const std::vector<Family>& families();
/// Throws std::invalid_argument for a name that is none of them.
const Family& family_named(std::string_view name);

/// What each count of a run of this method with this cure costs where the rows are of that kind.
Prices prices_of(std::string_view kind, const Family& family, Cure cure);

/// The name of a cure, and the symbol of its strength: "Baumgarte", "β".
std::string_view name_of(Cure cure);
std::string_view symbol_of(Cure cure);
/// ", 4 substeps, 2 sweeps, β = 0.05".
std::string described_knobs(const Family& family, const Knobs& knobs);

/// The same with another cure, at a strength to begin with.
Knobs with_cure(Knobs knobs, Cure cure);

}  // namespace byhand
