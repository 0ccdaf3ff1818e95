#pragma once

#include <cmath>

#include "lessons/laws/law.hpp"
#include "solver/measure.hpp"
#include "solver/step.hpp"

namespace byhand::laws {

/// The share of its error that one sweep of a solver leaves in the long run: a power iteration, whose first
/// sweeps, `settle`, do not count. A step is so short that nothing moves, and is one sweep if the solver starts
/// cold.
template <class M>
double left_by_a_sweep(Scene<M> scene, const RowSolver& one_sweep, int settle, int watch) {
  Simulation<M> simulation{std::move(scene), {one_sweep, NoDriftCure{}}};
  double log_sum = 0;
  for (int i = 0; i < settle + watch; ++i) {
    simulation.step(1e-200);
    // The residual of the rows before the last one, which is solved.
    const double error = residual(simulation.work.system, simulation.scene.bodies().velocity);
    if (error == 0) return 0;
    for (int body = 0; body < simulation.scene.bodies().size(); ++body)
      simulation.scene.set_velocity(body, simulation.scene.bodies().velocity[body] / error);
    if (i >= settle) log_sum += std::log(error);
  }
  return std::exp(log_sum / watch);
}

/// A straight weightless chain of unit links whose bobs fly up and down.
struct SweptChain {
  int links = 10;
  double end_mass = 1;  // in masses of a bob
  bool anchored = true;
  double relaxation = 1;  // other than 1 this is SOR
  SweepOrder order = SweepOrder::natural;
};
Scene<PlaneParticle> scene_of(const SweptChain& chain);
/// The share of an error that one sweep of Gauss–Seidel leaves in the long run.
double left_by_a_sweep(const SweptChain& chain);

/// What Jacobi leaves of the fall of a unit box that lies on so many contacts and rocks a little: settles or
/// explodes.
Outcome jacobi(int contacts, double relaxation);

/// The largest eigenvalue of D⁻¹A of those contacts.
double largest_eigenvalue(int contacts);

/// Law 4: what a sweep is worth.
Law slow_sweeps();

/// Law 5: when Jacobi converges.
Law jacobi_overshoots();

}  // namespace byhand::laws
