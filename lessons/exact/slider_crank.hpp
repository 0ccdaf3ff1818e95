#pragma once

namespace byhand {

/// A crank of radius r on a connecting rod of length l > r whose other end slides through the crank's pivot: at
/// the crank's angle θ from the way of the piston, it is x = r cosθ + √(l² - r² sin²θ) from the pivot.
class SliderCrank {
 public:
  /// Throws std::invalid_argument unless 0 < crank < rod [m].
  SliderCrank(double crank, double rod);

  /// x [m] at θ [rad]
  double position(double angle) const;
  /// dx/dθ [m/rad] at θ [rad]: the piston's speed over the crank's
  double speed(double angle) const;
  /// d²x/dθ² [m/rad²] at θ [rad]: the piston's acceleration over the square of the speed of a crank that turns
  /// steadily
  double acceleration(double angle) const;

 private:
  double crank_, rod_;
};

}  // namespace byhand
