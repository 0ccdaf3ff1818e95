#pragma once

#include <gtest/gtest.h>

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
template <class M>
double rod_angle(const Scene<M>& scene, int from, int to) {
  return angle_from_down((scene.bodies().pose[to].position - scene.bodies().pose[from].position).eval());
}

/// How fast that angle grows, of bodies that the rod holds by their centres, in the plane z = 0 [rad/s].
template <class M>
double rod_rate(const Scene<M>& scene, int from, int to) {
  const auto d = (scene.bodies().pose[to].position - scene.bodies().pose[from].position).eval();
  const auto v = (scene.bodies().velocity[to] - scene.bodies().velocity[from]).eval();
  return (d.x() * v.y() - d.y() * v.x()) / d.squaredNorm();
}

/// The energy of the parabolas that free bodies go along: steps of h pass through the points of one that begins
/// with V + gh/2 [J].
template <class M>
double energy_of_parabolas(Scene<M> scene, double h) {
  for (int i = 0; i < scene.bodies().size(); ++i)
    if (moves(scene.bodies().inverse_mass[i]))
      scene.state().velocity[i].template head<M::linear>() += h / 2 * scene.gravity;
  return energy(scene);
}

/// Runs for `time` [s] in steps of h [s], which must divide it, and calls `look` after each.
template <class M, class Method, class F>
void run(Simulation<M, Method>& simulation, double time, double h, F&& look) {
  const long steps = std::lround(time / h);
  for (long i = 0; i < steps; ++i) {
    simulation.step(h);
    look();
  }
}
template <class M, class Method>
void run(Simulation<M, Method>& simulation, double time, double h) {
  run(simulation, time, h, [] {});
}

/// A scene whose lengths and gravity are multiplied by a power of two does the same to the last bit: in units of
/// its length [m]. `scene_of` and `method_of` take that length.
template <class SceneOf, class MethodOf>
void expect_same_at_any_length(SceneOf&& scene_of, MethodOf&& method_of) {
  const auto after = [&](double length) {
    Simulation simulation{scene_of(length), method_of(length)};
    simulation.scene.gravity *= length;
    run(simulation, 1, 1.0 / 60);
    return simulation.scene.bodies();
  };
  const auto one = after(1);
  for (const double length : {0x1p-20, 0x1p20}) {
    const auto scaled = after(length);
    for (int i = 0; i < one.size(); ++i) {
      constexpr int axes = std::decay_t<decltype(one.pose[i].position)>::RowsAtCompileTime;
      auto V = scaled.velocity[i];
      V.template head<axes>() /= length;
      EXPECT_EQ(scaled.pose[i].position / length, one.pose[i].position) << "body " << i << ", length " << length;
      EXPECT_EQ(V, one.velocity[i]) << "body " << i << ", length " << length;
    }
  }
}

/// The same scene with a contact for each point where bodies touch, and with friction at each.
template <class M>
Scene<M> by_points(Scene<M> scene) {
  scene.set_contact_rows(ContactRows::points);
  return scene;
}

/// The times at which a sampled quantity changes sign, by linear interpolation, or by a cubic where its rate is
/// given [s].
class ZeroCrossings {
 public:
  explicit ZeroCrossings(double first, double first_rate = 0) : last_(first), last_rate_(first_rate) {}

  void add(double value, double time, double h) {
    if (last_ * value < 0) times.push_back(time - h * value / (value - last_));
    last_ = value;
  }
  void add(double value, double rate, double time, double h) {
    if (last_ * value < 0) {
      double s = last_ / (last_ - value);  // of the way from the last sample to this one, by Newton
      for (int i = 0; i < 5; ++i) {
        const double c = 3 * (value - last_) - h * (2 * last_rate_ + rate);
        const double d = 2 * (last_ - value) + h * (last_rate_ + rate);
        s -= (last_ + s * (h * last_rate_ + s * (c + s * d))) / (h * last_rate_ + s * (2 * c + s * 3 * d));
      }
      times.push_back(time - h * (1 - s));
    }
    last_ = value;
    last_rate_ = rate;
  }

  std::vector<double> times;

 private:
  double last_, last_rate_;
};

/// λ/h of a constraint's rows [units of C's conjugate force].
template <class AnyWork>
double force(const AnyWork& work, int constraint, int row = 0) {
  return work.system.lambda[work.system.row_of[constraint] + row] / work.h;
}

/// The order p of an error that shrinks from `coarse` to `fine` when h is halved: coarse/fine = 2^p.
inline double order(double coarse, double fine) { return std::log2(std::abs(coarse / fine)); }

}  // namespace byhand
