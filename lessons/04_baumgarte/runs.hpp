#pragma once

#include "lessons/04_baumgarte/setting.hpp"

namespace byhand::baumgarte {

using Vector = Linear<PlaneParticle>;

/// A bob at rest in weightlessness, on a rod that begins `error` [m] too long: the error [m] at the beginning and
/// after each step of h [s], until a step throws the bob through the anchor. There the rod's direction turns round
/// and |d| − L is another error.
std::vector<double> errors(const Setting& setting, const Baumgarte& cure, double h, int steps);

/// The same rod in the article's squared form (2), after one step [m].
double error_in_squared_form(const Setting& setting);

/// How long an error takes to halve when a step of h leaves the share `factor` of it [s].
double half_life(double factor, double h);

/// A bob after a step.
struct Sample {
  double time;  // [s]
  Vector position, velocity;
  double kinetic, potential;  // [J]; potential is zero at the anchor's height
};
using Track = std::vector<Sample>;

/// A bob that goes round the anchor without gravity: the beginning and every step.
Track circling(const Setting& setting, double speed, const DriftCure& cure, double h, int steps);
/// A pendulum let go at the lesson's `release`: the beginning and every step, until its rod is a hundred times as
/// long.
Track swinging(const Setting& setting, const DriftCure& cure, double h, int steps);

}  // namespace byhand::baumgarte
