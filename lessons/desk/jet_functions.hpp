#pragma once

#include <cmath>

#include "solver/integrate/jet.hpp"

// Functions of jets that typed formulas may hold, beyond those that the solver's own constraints need.
namespace byhand {

/// f(a) of a function with the derivatives f' and f'' at a.
inline Jet composed(const Jet& a, double f, double slope, double bend) {
  return {f, slope * a.rate, bend * a.rate * a.rate + slope * a.bend};
}
inline Jet sin(const Jet& a) { return composed(a, std::sin(a.at), std::cos(a.at), -std::sin(a.at)); }
inline Jet cos(const Jet& a) { return composed(a, std::cos(a.at), -std::sin(a.at), -std::cos(a.at)); }
inline Jet abs(const Jet& a) { return a.at < 0 ? -a : a; }
/// With φ = atan2(y, x): φ' = (x y' - y x')/ρ, ρ = x² + y², and φ'' by the quotient rule.
inline Jet atan2(const Jet& y, const Jet& x) {
  const double squared = x.at * x.at + y.at * y.at, rate = (x.at * y.rate - y.at * x.rate) / squared;
  const double bend = (x.at * y.bend - y.at * x.bend - 2 * rate * (x.at * x.rate + y.at * y.rate)) / squared;
  return {std::atan2(y.at, x.at), rate, bend};
}

}  // namespace byhand
