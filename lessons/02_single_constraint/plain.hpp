#pragma once

#include "lessons/02_single_constraint/setting.hpp"

// The article's step for one rod, written for this lesson's bob alone. The solver's general code is held against
// it.
namespace byhand::single_constraint {

//! [19]
/// (19) for a rod between two particles: nothing turns, so two of its four terms are left.
inline double plain_inverse_effective_mass(const Vector& l1, double inverse_mass1, const Vector& l2,
                                           double inverse_mass2) {
  return l1.dot(l1) * inverse_mass1 + l2.dot(l2) * inverse_mass2;
}
//! [19]

//! [step]
/// One time step of a bob at x with velocity v on a rod from the origin; g is gravity, b = 0.
inline void plain_step(Vector& x, Vector& v, double m, const Vector& g, double h) {
  v += h * g;                     // gravity, before λ
  const Vector d = x;             // (11); J = [−d d] by (14)
  const double JV = d.dot(v);     // (8)
  const double K = d.dot(d) / m;  // (19)
  const double lambda = -JV / K;  // (17)
  v += lambda / m * d;            // (20)
  x += h * v;
}
//! [step]

}  // namespace byhand::single_constraint
