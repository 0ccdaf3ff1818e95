#pragma once

#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "tests/solver/law_motion.hpp"

// What the rows of table A1 are measured by, for any method.
namespace byhand {

struct SwingErrors {
  double period_error;  // relative, of the first swing through the bottom and back
  double angle_error;   // after 1 s [rad]
  double stretch;       // of the rod, at most [m]
  double energy_gain;   // in units of m g L
};

/// Ten seconds of a pendulum from rest at 90°, against the elliptic functions.
template <template <class> class Rod, class Method>
SwingErrors swing(const Method& method, double h, double length = 1, double mass = 1) {
  constexpr double level = std::numbers::pi / 2;
  Simulation<PlaneParticle, Method> simulation{pendulum<PlaneParticle, Rod>(level, length, mass), method};
  const double g = -simulation.scene.gravity.y(), start = energy(simulation.scene);
  const SimplePendulum exact(level, length, g);
  SwingErrors result{};
  ZeroCrossings bottom(level);
  run(simulation, 10, h, [&] {
    const double angle = rod_angle(simulation.scene, 0, 1);
    bottom.add(angle, rod_rate(simulation.scene, 0, 1), simulation.time, h);
    const double distance = simulation.scene.bodies().pose[1].position.norm();
    result.stretch = std::max(result.stretch, std::abs(distance - length));
    if (std::abs(simulation.time - 1) < h / 2) result.angle_error = angle - exact.angle(1);
  });
  result.period_error = (bottom.times.at(2) - bottom.times.at(0)) / exact.period() - 1;
  result.energy_gain = (energy(simulation.scene) - start) / (mass * g * length);
  return result;
}

/// The atlas gives two digits: its number and ours may differ by one unit of the last.
inline void expect_two_digits(double measured, double atlas, const char* what) {
  const double unit = std::pow(10, std::floor(std::log10(std::abs(atlas))) - 1);
  EXPECT_NEAR(measured, atlas, unit) << what;
}
inline void expect_row(const SwingErrors& measured, const SwingErrors& atlas) {
  expect_two_digits(measured.period_error, atlas.period_error, "period");
  expect_two_digits(measured.angle_error, atlas.angle_error, "angle after 1 s");
  expect_two_digits(measured.stretch, atlas.stretch, "stretch");
  expect_two_digits(measured.energy_gain, atlas.energy_gain, "energy");
}

}  // namespace byhand
