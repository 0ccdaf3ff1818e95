#pragma once

#include "lessons/02_single_constraint/setting.hpp"

// (19) for one rod, written for this lesson's bob alone. The solver's general code is held against it.
namespace byhand::single_constraint {

//! [19]
/// (19) for a rod between two particles: nothing turns, so two of its four terms are left.
inline double plain_inverse_effective_mass(const Vector& l1, double inverse_mass1, const Vector& l2,
                                           double inverse_mass2) {
  return l1.dot(l1) * inverse_mass1 + l2.dot(l2) * inverse_mass2;
}
//! [19]

}  // namespace byhand::single_constraint
