#pragma once

#include "lessons/laws/law.hpp"

namespace byhand::laws {

/// A straight weightless chain of unit links whose bobs fly up and down.
struct SweptChain {
  int links = 10;
  double end_mass = 1;  // in masses of a bob
  bool anchored = true;
  double relaxation = 1;  // other than 1 this is SOR
};
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
