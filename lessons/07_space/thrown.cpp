#include "lessons/07_space/thrown.hpp"

#include "lessons/scenes/top.hpp"

namespace byhand::space {

Eigen::Vector3d moments_of(const Setting& setting) {
  return box<SpaceBody>(setting.mass, book_sides()).angular.cwiseInverse();
}

Eigen::Vector3d first_spin(const Setting& setting, double wobble) {
  return setting.spin() * Eigen::Vector3d(wobble, 1, wobble);
}

Flight thrown(const Setting& setting, double wobble, Gyroscopic choice, double seconds) {
  return thrown(setting, wobble, choice, seconds, setting.h);
}

Flight thrown(const Setting& setting, double wobble, Gyroscopic choice, double seconds, double h) {
  const Eigen::Vector3d spin = first_spin(setting, wobble);
  Simulation<SpaceBody> book{free_top(moments_of(setting), spin), {Direct{}, NoDriftCure{}}};
  book.method.gyroscopic = choice;
  const auto& bodies = book.scene.bodies();
  const auto steps = std::lround(seconds / h);
  const double limit = 100 * spin.norm();
  Flight flight;
  for (long i = 0; i <= steps; ++i) {
    const Eigen::Vector3d omega = bodies.velocity[0].tail<3>();
    if (!(omega.norm() < limit)) break;
    flight.push_back({i * h, bodies.pose[0], omega, angular_momentum(bodies), kinetic_energy(bodies)});
    book.step(h);
  }
  return flight;
}

bool flew_apart(const Flight& flight, double seconds) {
  const double h = flight[1].time - flight[0].time;
  return flight.back().time < seconds - h;
}

std::vector<double> flips_of(const Flight& flight) {
  std::vector<double> times;
  for (std::size_t i = 1; i < flight.size(); ++i) {
    const double before = flight[i - 1].spin().y(), now = flight[i].spin().y();
    if (before * now < 0)
      times.push_back(flight[i].time - (flight[i].time - flight[i - 1].time) * now / (now - before));
  }
  return times;
}

}  // namespace byhand::space
