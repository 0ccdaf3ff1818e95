#pragma once

#include <span>

#include "solver/step.hpp"
#include "tests/fuzz/recipe.hpp"

namespace byhand::fuzz {

inline constexpr double h = 1.0 / 60;  // of every step [s]

/// What every scene keeps. `broken` says what breaks it, with the number, or nothing.
template <class M>
struct Law {
  const char* name;
  std::string (*broken)(const Recipe<M>&, const VelocityStepping&);
  bool to_the_end = false;  // whether rows are solved to rounding, for what is compared
};

/// Of two seconds: all numbers are finite; impulses and gravity give the velocities; what a step calls converged
/// is; bodies that touch do not sink into each other; no energy comes from nowhere. Of one step that is solved to
/// the end: it does not depend on who looks, and from where.
template <class M>
std::span<const Law<M>> laws();

/// What breaks a law. A step that throws breaks no law but that of finite numbers.
template <class M>
std::string broken(const Law<M>& law, const Recipe<M>& recipe, const VelocityStepping& method);

/// The scene as it is after so many steps.
template <class M>
Recipe<M> after(const Recipe<M>& recipe, const VelocityStepping& method, int steps);

}  // namespace byhand::fuzz
