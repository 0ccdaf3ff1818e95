#include <cmath>

#include "lessons/09_what_accuracy_costs/catalogue/work_precision.hpp"

namespace byhand {
namespace {

const std::vector<double> betas{0, 0.05, 0.2, 1};

/// first, 2 first, 4 first … last
std::vector<int> doubling(int first, int last) {
  std::vector<int> values;
  for (int value = first; value <= last; value *= 2) values.push_back(value);
  return values;
}

VelocityStepping stepping(const RowSolver& solver, const DriftCure& cure, int substeps = 1) {
  VelocityStepping method{solver, cure};
  method.substeps = substeps;
  method.gyroscopic = Gyroscopic::implicit;
  return method;
}

/// Rows solved by `solver(sweeps)` in one step a frame.
template <class Solver>
Configuration by_sweeps(const std::string& name, std::string knob, int most, Solver solver) {
  return {.name = name + ", " + knob,
          .knob = knob,
          .values = doubling(1, most),
          .tuning = "β",
          .tunings = betas,
          .shortens_step = false,
          .setting = [=](int sweeps, double beta) { return Setting{stepping(solver(sweeps), Baumgarte{beta})}; }};
}

/// Rows solved by `solver` in each of so many substeps, with `cure(tuning, substep)`.
template <class Cure>
Configuration by_substeps(const std::string& name, int most, const RowSolver& solver, std::string tuning,
                          std::vector<double> tunings, Cure cure) {
  return {.name = name + ", substeps",
          .knob = "substeps",
          .values = doubling(1, most),
          .tuning = tuning,
          .tunings = tunings,
          .setting = [=](int substeps, double value) {
            return Setting{stepping(solver, cure(value, frame / substeps), substeps)};
          }};
}

/// A family that has substeps and nothing to tune.
template <class Family>
Configuration by_substeps(const std::string& name, int most, Family family) {
  return {.name = name + ", substeps",
          .knob = "substeps",
          .values = doubling(1, most),
          .tuning = "",
          .tunings = {0},
          .setting = [=](int substeps, double) {
            Family method = family;
            method.substeps = substeps;
            return Setting{method};
          }};
}

/// The same as it comes.
Configuration by_default(Configuration configuration, double tuning) {
  configuration.name += ", defaults";
  configuration.tunings = {tuning};
  configuration.defaults = true;
  return configuration;
}

std::vector<Configuration> make_configurations() {
  const auto baumgarte = [](double beta, double) { return Baumgarte{beta}; };
  const auto split = [](double beta, double) { return SplitImpulse{beta}; };
  const auto soft = [](double share, double h) { return SoftConstraints{.frequency = share / h}; };
  const auto projection = [](double sweeps, double) { return Projection{static_cast<int>(sweeps)}; };

  const Configuration direct = by_substeps("direct", 256, Direct{}, "β", betas, baumgarte);
  const Configuration sweeps =
      by_sweeps("Gauss–Seidel", "sweeps", 1024, [](int count) { return GaussSeidel{count}; });
  const Configuration substeps = by_substeps("Gauss–Seidel", 256, GaussSeidel{1}, "β", betas, baumgarte);
  Configuration relaxed = by_sweeps("SOR", "sweeps", 1024, [](int) { return GaussSeidel{}; });
  relaxed.tuning = "ω";
  relaxed.tunings = {1.3, 1.6, 1.9};
  relaxed.setting = [](int count, double omega) {
    return Setting{stepping(GaussSeidel{.sweeps = count, .relaxation = omega}, NoDriftCure{})};
  };
  const auto avbd = [](int iterations, double alpha) {
    return Setting{Avbd{.iterations = iterations, .alpha = alpha, .gyroscopic = Gyroscopic::implicit}};
  };

  return {
      direct,
      by_default(direct, 0.2),
      by_substeps("conjugate sweeps", 64, ConjugateSweeps{}, "β", betas, baumgarte),
      by_substeps("RATTLE", 64, Rattle{}),
      by_substeps("implicit midpoint", 64, Accelerations{Scheme::implicit_midpoint}),
      by_substeps("RK4", 64, Accelerations{Scheme::rk4}),
      by_substeps("explicit Euler", 256, Accelerations{Scheme::explicit_euler}),
      substeps,
      by_substeps("Gauss–Seidel with split impulse", 256, GaussSeidel{1}, "β", {0.05, 0.2, 1}, split),
      by_substeps("Gauss–Seidel with soft constraints", 256, GaussSeidel{1}, "ωh", {0.1, 0.4, 1.6}, soft),
      by_substeps("Gauss–Seidel with projection", 256, GaussSeidel{1}, "projections", {1, 4}, projection),
      by_substeps("XPBD", 256, Xpbd{.gyroscopic = Gyroscopic::implicit}),
      sweeps,
      by_default(sweeps, 0.2),
      relaxed,
      by_sweeps("symmetric Gauss–Seidel", "sweeps", 512,
                [](int count) { return GaussSeidel{.sweeps = count, .order = SweepOrder::symmetric}; }),
      by_sweeps("Jacobi", "sweeps", 1024, [](int count) { return Jacobi{.sweeps = count, .relaxation = 0.5}; }),
      by_sweeps("conjugate sweeps", "sweeps", 1024,
                [](int count) { return ConjugateSweeps{.sweeps = count, .tolerance = 0}; }),
      by_sweeps("conjugate gradients", "iterations", 256,
                [](int count) { return ConjugateGradients{.iterations = count, .tolerance = 0}; }),
      by_sweeps("accelerated gradient", "iterations", 1024,
                [](int count) { return AcceleratedGradient{.iterations = count, .tolerance = 0}; }),
      {.name = "AVBD, iterations",
       .knob = "iterations",
       .values = doubling(1, 1024),
       .tuning = "α",
       .tunings = {0, 0.95},
       .shortens_step = false,
       .setting = avbd},
  };
}

}  // namespace

const std::vector<Configuration>& configurations() {
  static const std::vector<Configuration> all = make_configurations();
  return all;
}

const Configuration& configuration_named(std::string_view name) {
  for (const Configuration& configuration : configurations())
    if (configuration.name == name) return configuration;
  std::string names;
  for (const Configuration& configuration : configurations())
    names += (names.empty() ? "\"" : ", \"") + configuration.name + '"';
  require(false, "configuration", name, "one of " + names);
  return configurations().front();
}

}  // namespace byhand
