#pragma once

#include <cmath>

#include "lessons/page/words.hpp"

// Numbers that are nothing but rounding are never printed as results.
namespace byhand::course {

/// `value`, or 0 where it is no more than the rounding of numbers as large as `size`.
inline double without_rounding(double value, double size) { return std::abs(value) <= 1e-13 * size ? 0 : value; }

/// A vector without the components that are only rounding beside its others.
template <class Vector>
Vector without_rounding(Vector vector) {
  const double size = vector.cwiseAbs().maxCoeff();
  for (double& component : vector) component = without_rounding(component, size);
  return vector;
}

/// An error that may be as small as rounding: "3.2·10⁻⁷", or "less than 10⁻¹¹".
inline Value small_error(double size, int digits = 2) {
  if (std::abs(size) < 1e-11) return {"less than 10⁻¹¹", R"(\text{less than } 10^{-11})"};
  return {size, digits};
}

}  // namespace byhand::course
