#include "lessons/02_single_constraint/swing.hpp"

namespace byhand::single_constraint {

Swing swing(Pendulum scene, double h, double seconds) {
  Simulation simulation{std::move(scene), one_row_solved()};
  Swing swing;
  const auto steps = static_cast<int>(std::lround(seconds / h));
  for (int i = 0; i <= steps; ++i) {
    const auto& bodies = simulation.scene.bodies();
    const auto& rod = simulation.scene.all<Distance>().front();
    const Vector position = bodies.pose[1].position, velocity = bodies.velocity[1];
    const double C = rod.value<double>(bodies.pose[0], bodies.pose[1])[0], now = energy(simulation.scene);
    simulation.step(h);
    const double mass = 1 / bodies.inverse_mass[1].linear;
    swing.push_back({i * h, position, velocity, C, now, -simulation.impulse(0)[0] * position.norm() / h,
                     0.5 * mass * (bodies.velocity[1] - velocity).squaredNorm()});
  }
  return swing;
}

Swing swing(const Setting& setting, double h, double seconds) {
  return swing(pendulum<PlaneParticle>(radians(setting.release()), setting.length(), setting.mass()), h, seconds);
}

}  // namespace byhand::single_constraint
