#pragma once

#include <span>

#include "solver/work.hpp"

namespace byhand {

/// The force of a constraint on its second body; its first body gets the opposite force.
template <class M>
struct Reaction {
  Linear<M> force = Linear<M>::Zero();      // [N]
  Angular<M> torque1 = Angular<M>::Zero();  // on the first body, about its centre of mass [N m]
  Angular<M> torque2 = Angular<M>::Zero();  // on the second [N m]
};

/// Jᵀλ/h of a constraint, by its handle or identity, in the last substep. Throws std::invalid_argument for one
/// that the scene does not have or that took no part in the last step.
template <class M>
Reaction<M> reaction(const Scene<M>& scene, const StepWork<M>& work, int constraint);

/// λ of the constraint's rows in the last substep, until the next step [N s, or what is conjugate to C]. Throws
/// the same.
template <class M>
std::span<const double> impulse(const Scene<M>& scene, const StepWork<M>& work, int constraint);

}  // namespace byhand
