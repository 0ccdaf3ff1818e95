#include "lessons/04_baumgarte/runs.hpp"

#include "lessons/scenes/circle.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::baumgarte {
namespace {

/// One row is solved exactly by (17): one cold sweep.
VelocityStepping one_row(const DriftCure& cure) { return {GaussSeidel{.sweeps = 1, .warm_start = false}, cure}; }

template <template <class> class Rod>
std::vector<double> weightless(const Setting& setting, const Baumgarte& cure, double h, int steps) {
  Simulation<PlaneParticle> simulation{pendulum<PlaneParticle, Rod>(0, setting.length, setting.mass),
                                       one_row(cure)};
  simulation.scene.gravity.setZero();
  const Vector& bob = simulation.scene.bodies().pose[1].position;
  simulation.scene.set_position(1, bob * (1 + setting.error / setting.length));
  std::vector<double> errors{setting.error};
  for (int i = 0; i < steps; ++i) {
    simulation.step(h);
    if (-bob.y() < 0.05 * setting.length) break;
    errors.push_back(-bob.y() - setting.length);
  }
  return errors;
}

Track follow(Scene<PlaneParticle> scene, const DriftCure& cure, double h, int steps) {
  Simulation<PlaneParticle> simulation{std::move(scene), one_row(cure)};
  Track track;
  const auto& bodies = simulation.scene.bodies();
  const double far = 100 * bodies.pose[1].position.norm();
  for (int i = 0; i <= steps && bodies.pose[1].position.norm() < far; ++i) {
    if (i > 0) simulation.step(h);
    track.push_back({i * h, bodies.pose[1].position, bodies.velocity[1], kinetic_energy(bodies),
                     potential_energy(simulation.scene)});
  }
  return track;
}

}  // namespace

std::vector<double> errors(const Setting& setting, const Baumgarte& cure, double h, int steps) {
  return weightless<NormalisedDistance>(setting, cure, h, steps);
}

double error_in_squared_form(const Setting& setting) {
  return weightless<Distance>(setting, {setting.beta()}, setting.h, 1).back();
}

double half_life(double factor, double h) { return h * std::log(0.5) / std::log(factor); }

Track circling(const Setting& setting, double speed, const DriftCure& cure, double h, int steps) {
  return follow(particle_on_a_circle<PlaneParticle>(setting.length, speed, setting.mass), cure, h, steps);
}

Track swinging(const Setting& setting, const DriftCure& cure, double h, int steps) {
  return follow(
      pendulum<PlaneParticle, NormalisedDistance>(radians(setting.release()), setting.length, setting.mass), cure,
      h, steps);
}

}  // namespace byhand::baumgarte
