#pragma once

#include "lessons/05_contact/setting.hpp"

#include "solver/constraints/normalised_distance.hpp"

namespace byhand::contact {

/// Newton's cradle as it hangs: balls on rods in a row, the first drawn aside and let go; e = 1, solved directly.
class HangingCradle {
 public:
  static constexpr double seconds = 3;
  static constexpr double gap = 0.004;                                // [m]
  static constexpr double touching_step = 1.0 / 60, gap_step = 1e-3;  // [s]

  /// `air` [m] between the balls at rest, stepped by h [s].
  HangingCradle(int balls, double air, double h);

  /// Steps up to a time [s].
  void advance(double time);
  void draw(renderer::Canvas& canvas, const renderer::Rectangle& frame, const std::string& name) const;

 private:
  Simulation<PlaneBody> simulation_;
  double h_;
};

}  // namespace byhand::contact
