#pragma once

#include <functional>

#include "lessons/methods/method.hpp"
#include "lessons/scenes/chain.hpp"

// Until which step a method is stable on a chain of bobs that hangs straight down: by linear algebra, and by runs.
namespace byhand {

/// The spectral radius of one step of h [s], linearised about the chain at rest, for motion to the side: the
/// largest modulus of an eigenvalue. By symmetry such motion changes no force to first order, whatever the method
/// keeps between steps, so that positions and velocities to the side are the whole state. Infinite where a step
/// has no solution.
double spectral_radius(const ChainOptions& chain, const Method& method, double h);

/// Whether a thousand steps of h [s] leave the chain within a thousand times the width of a small disturbance to
/// the side.
bool stays(const ChainOptions& chain, const Method& method, double h);

/// The step [s] up to which `stable(h)` holds, upwards from 10⁻⁴ s and to a thousandth; infinite if it still does
/// at `longest`.
double longest_step(const std::function<bool(double h)>& stable, double longest);

}  // namespace byhand
