#pragma once

#include "solver/constraints/motor.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/scene.hpp"

// How long a step may be before it hides what springs do. A step h of velocities damps an oscillation of ω by
// e^(-ω²h/2) a second, as implicit Euler does. Once that has taken it away, runs of two steps agree, and are
// wrong.
namespace byhand::stage {

/// The largest ω² of a spring or servo [1/s²] whose own damper leaves an oscillation for so long [s]; 0 without
/// one.
template <class M>
double fastest_oscillation(const Scene<M>& scene, double time) {
  constexpr double gone = 14;  // e^-14 is a millionth
  const Bodies<M>& bodies = scene.bodies();
  double fastest = 0;
  const auto look = [&](const auto& all) {
    for (const auto& row : all) {
      if (!moves(bodies.inverse_mass[row.at.body1]) && !moves(bodies.inverse_mass[row.at.body2])) continue;
      const double mass = tuned(bodies, row, 1, 0).stiffness;  // that oscillates with ω = 1 by k = m
      if (0.5 * row.elastic.damping / mass * time < gone)
        fastest = std::max(fastest, row.elastic.stiffness / mass);
    }
  };
  look(scene.template all<Spring<M>>());
  if constexpr (M::angular > 0)
    look(scene.template all<Servo<M, Turn>>()), look(scene.template all<Servo<M, Slide>>());
  return fastest;
}

}  // namespace byhand::stage
