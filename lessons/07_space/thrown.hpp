#pragma once

#include "lessons/07_space/setting.hpp"
#include "solver/integrate/gyroscopic.hpp"

namespace byhand::space {

/// The book's principal moments [kg m²].
Eigen::Vector3d moments_of(const Setting& setting);
/// Its spin at first about its own axes [rad/s]: about the middle one, and a share `wobble` of that about the
/// others.
Eigen::Vector3d first_spin(const Setting& setting, double wobble);

/// A book that has been thrown, at one instant.
struct Instant {
  double time;  // [s]
  Pose<SpaceBody> pose;
  Eigen::Vector3d omega;     // in the world [rad/s]
  Eigen::Vector3d momentum;  // Iω in the world [kg m²/s]
  double energy;             // [J]

  /// In the book's own axes [rad/s].
  Eigen::Vector3d spin() const { return rotate(inverse(pose.rotation), omega); }
};
using Flight = std::vector<Instant>;

/// The flight without gravity, from its start on, one instant a step. It ends early once the spin passes a
/// hundredfold of what it was.
Flight thrown(const Setting& setting, double wobble, Gyroscopic choice, double seconds);
/// The same with steps of `h` [s].
Flight thrown(const Setting& setting, double wobble, Gyroscopic choice, double seconds, double h);

/// Whether it ended before it should.
bool flew_apart(const Flight& flight, double seconds);
/// The times at which the spin about the middle axis changes sign [s].
std::vector<double> flips_of(const Flight& flight);

}  // namespace byhand::space
