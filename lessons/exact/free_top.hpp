#pragma once

#include <Eigen/Core>
#include <vector>

namespace byhand {

/// A body that nothing holds or pulls, with three different principal moments: Euler's equations in its own axes,
/// IΩ̇ = IΩ × Ω. Ω is a curve on which both 2E = Ω·IΩ and |IΩ|² stay; about the middle axis it goes as an elliptic
/// sine, so a spin near it turns over every half period (Landau and Lifshitz, Mechanics, §37).
class FreeTop {
 public:
  struct Spin {
    Eigen::Vector3d value;  // in the body's axes [rad/s]
    double uncertainty;     // largest error expected in any of them [rad/s]
  };

  /// `moments` [kg m²], three different ones, in any order that a body can have, and the spin at first about the
  /// same axes [rad/s]. Throws std::invalid_argument for moments that are not positive, no two of them apart or
  /// one above the sum of the others, and for a spin of zero.
  FreeTop(const Eigen::Vector3d& moments, const Eigen::Vector3d& spin);

  /// From a spin back to the same spin [s]; infinite on the separatrix, where it tends to the middle axis and
  /// never turns over.
  double period() const;
  /// The spin after `time` [s] >= 0.
  Spin at(double time) const;
  /// The spins after 0, end/parts, … `end` [s], in the body's axes [rad/s]: for a curve (see integrated_path).
  std::vector<Eigen::Vector3d> path(double end, int parts) const;

 private:
  Eigen::Vector3d moments_, spin_;
};

}  // namespace byhand
