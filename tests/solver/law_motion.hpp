#pragma once

#include <cmath>
#include <vector>

#include "solver/measure.hpp"

// What the laws of the atlas measure on a moving scene.
namespace byhand {

/// Angle of a vector from straight down, towards +x [rad].
template <class V>
double angle_from_down(const V& d) {
  return std::atan2(d.x(), -d.y());
}

/// Angle of the rod from one body to another [rad].
template <class S>
double rod_angle(const S& scene, int from, int to) {
  return angle_from_down((scene.bodies.pose[to].position - scene.bodies.pose[from].position).eval());
}

/// Runs for `time` [s] in steps of h [s], which must divide it, and calls `look` after each.
template <class S, class F>
void run(Simulation<S>& simulation, double time, double h, F&& look) {
  const long steps = std::lround(time / h);
  for (long i = 0; i < steps; ++i) {
    simulation.step(h);
    look();
  }
}
template <class S>
void run(Simulation<S>& simulation, double time, double h) {
  run(simulation, time, h, [] {});
}

/// The times at which a sampled quantity changes sign, by linear interpolation [s].
class ZeroCrossings {
 public:
  explicit ZeroCrossings(double first) : last_(first) {}

  void add(double value, double time, double h) {
    if (last_ * value < 0) times.push_back(time - h * value / (value - last_));
    last_ = value;
  }

  std::vector<double> times;

 private:
  double last_;
};

/// λ/h of a constraint's rows [units of C's conjugate force].
template <class M>
double force(const Work<M>& work, int constraint, int row = 0) {
  return work.system.lambda[work.system.row_of[constraint] + row] / work.h;
}

/// The order p of an error that shrinks from `coarse` to `fine` when h is halved: coarse/fine = 2^p.
inline double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

}  // namespace byhand
