#pragma once

#include "lessons/scenes/rod.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A motor turns a crank, which moves a piston by a connecting rod.
struct SliderCrankOptions {
  double crank = 0.5, rod = 1.5;                         // lengths [m], rod > crank
  double crank_mass = 1, rod_mass = 1, piston_mass = 1;  // [kg]
  double speed = 6;                                      // of the motor [rad/s]
  double strength = 1e6;                                 // of the motor [N m]
  double angle = 0;                                      // of the crank at first, from the piston's way [rad]
};

/// Without gravity, and already moving at the motor's speed. Body 0 is the ground, 1 the crank, which turns about
/// the origin, 2 the rod, 3 the piston, which slides along the x axis. Constraints 0, 1 and 2 are the pins, 3 the
/// slider, 4 the motor.
inline Scene<PlaneBody> slider_crank(const SliderCrankOptions& machine) {
  require(machine.rod > machine.crank, "length of the rod", machine.rod, "above that of the crank");
  using M = PlaneBody;
  Scene<M> scene;
  scene.gravity.setZero();
  const auto [sin, cos] = sin_cos(machine.angle);
  const Linear<M> pivot(0, 0), knee = machine.crank * Linear<M>(cos, sin);
  const double reach = std::sqrt(machine.rod * machine.rod - knee.y() * knee.y());
  const Linear<M> wrist(knee.x() + reach, 0);
  const PlaneRod crank(pivot, knee, machine.crank_mass), rod(knee, wrist, machine.rod_mass);

  // Each of them turns with its rod, whose ends move as their neighbours do.
  const double rod_speed = -machine.speed * knee.x() / reach;
  const Linear<M> knee_velocity = machine.speed * Linear<M>(-knee.y(), knee.x());
  const Linear<M> half_turn = 0.5 * rod_speed * Linear<M>(knee.y(), reach);
  const Linear<M> rod_velocity = knee_velocity + half_turn, piston_velocity = knee_velocity + 2 * half_turn;

  const int ground = scene.add_body(pivot, fixed<M>());
  const int turning = scene.add_body(crank.pose, crank.mass,
                                     Velocity<M>(knee_velocity.x() / 2, knee_velocity.y() / 2, machine.speed));
  const int connecting =
      scene.add_body(rod.pose, rod.mass, Velocity<M>(rod_velocity.x(), rod_velocity.y(), rod_speed));
  const int piston = scene.add_body(wrist, box<M>(machine.piston_mass, Linear<M>(0.4, 0.3)),
                                    Velocity<M>(piston_velocity.x(), 0, 0));
  scene.add(pin<M>(scene.bodies(), ground, turning, pivot));
  scene.add(pin<M>(scene.bodies(), turning, connecting, knee));
  scene.add(pin<M>(scene.bodies(), connecting, piston, wrist));
  scene.add(slider<M>(scene.bodies(), ground, piston, wrist, Linear<M>(1, 0)));
  scene.add(motor<M>(turn<M>(scene.bodies(), ground, turning), machine.speed, machine.strength));
  return scene;
}

}  // namespace byhand
