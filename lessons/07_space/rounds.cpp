#include "lessons/07_space/rounds.hpp"

#include "lessons/scenes/conical_pendulum.hpp"
#include "lessons/scenes/spherical_pendulum.hpp"

namespace byhand::space {
namespace {

/// One row is solved exactly by (17): one cold sweep.
VelocityStepping one_row() { return {GaussSeidel{.sweeps = 1, .warm_start = false}, Baumgarte{0.2}}; }

Eigen::Vector3d place(const Bob& bob) { return bob.scene.bodies().pose[1].position; }

/// How far round the upward vertical it is from one place to another [rad].
double turn(const Eigen::Vector3d& a, const Eigen::Vector3d& b) {
  return std::atan2(a.z() * b.x() - a.x() * b.z(), a.x() * b.x() + a.z() * b.z());
}

}  // namespace

Bob circling(const Setting& setting, double angle) {
  return {conical_pendulum(angle, setting.length, setting.mass), one_row()};
}

Bob set_out(const Setting& setting) {
  const double angle = radians(setting.angle);
  const double rate = setting.share * ConicalPendulum(angle, setting.length, gravity).angular_velocity();
  return {spherical_pendulum<SpaceParticle>(angle, rate, setting.length, setting.mass), one_row()};
}

double from_down(const Bob& bob) {
  const Eigen::Vector3d x = place(bob);
  return std::atan2(std::hypot(x.x(), x.z()), -x.y());
}

double tension(const Bob& bob) { return -bob.work.system.lambda[0] / bob.work.h; }

Nutation nutation_of(Bob bob, double h) {
  double azimuth = 0, rising = bob.scene.bodies().velocity[1].y();
  std::vector<double> times, azimuths;
  while (times.size() < 3) {
    const Eigen::Vector3d before = place(bob);
    bob.step(h);
    const double turned = turn(before, place(bob)), now = bob.scene.bodies().velocity[1].y();
    azimuth += turned;
    if (rising * now < 0) {
      const double beyond = now / (now - rising);  // the share of the step after it stood still
      times.push_back(bob.time - beyond * h);
      azimuths.push_back(azimuth - beyond * turned);
    }
    rising = now;
  }
  return {times[2] - times[0], azimuths[2] - azimuths[0]};
}

Turn third_turn(Bob bob, double h) {
  double azimuth = 0, from = 0;
  Turn third;
  int steps = 0;
  while (true) {
    const Eigen::Vector3d before = place(bob);
    bob.step(h);
    const double turned = std::abs(turn(before, place(bob)));
    const auto passes = [&](double goal) { return azimuth < goal && azimuth + turned >= goal; };
    const auto when = [&](double goal) { return bob.time - (azimuth + turned - goal) / turned * h; };
    if (passes(4 * pi)) from = when(4 * pi);
    if (passes(6 * pi)) {
      third.tension /= steps;
      third.distance /= steps;
      third.period = when(6 * pi) - from;
      return third;
    }
    azimuth += turned;
    if (azimuth < 4 * pi) continue;
    third.tension += tension(bob);
    third.distance += place(bob).norm();
    third.least = std::min(third.least, from_down(bob));
    third.most = std::max(third.most, from_down(bob));
    ++steps;
  }
}

}  // namespace byhand::space
