#pragma once

#include <stdexcept>

// NaN and infinity: what a step throws instead of leaving them in a scene, and a maximum that shows them.
namespace byhand {

/// Thrown by a step that would leave a number in the scene that is not finite, or a spin too fast to be followed.
struct NotFinite : std::runtime_error {
  using std::runtime_error::runtime_error;
};

/// The larger of two numbers, NaN if either is. std::max(x, NaN) is x.
inline double larger(double a, double b) { return a >= b || a != a ? a : b; }

}  // namespace byhand
