#include <cmath>

#include "solver/catalogue/work_precision.hpp"

namespace byhand {
namespace {

const std::vector<double> betas{0, 0.05, 0.2, 0.5, 1};

/// first, 2 first, 4 first … last
std::vector<int> doubling(int first, int last) {
  std::vector<int> values;
  for (int value = first; value <= last; value *= 2) values.push_back(value);
  return values;
}

VelocityStepping stepping(const RowSolver& solver, double beta, int substeps = 1) {
  VelocityStepping method{solver, Baumgarte{beta}};
  method.substeps = substeps;
  method.gyroscopic = Gyroscopic::implicit;
  return method;
}

/// Rows solved by `solver(sweeps)` in one step a frame.
template <class Solver>
Configuration by_sweeps(std::string name, int most, Solver solver) {
  return {name + ", sweeps", "sweeps", doubling(1, most), "β", betas, false, false, [=](int sweeps, double beta) {
            return Setting{stepping(solver(sweeps), beta)};
          }};
}

/// Rows solved by `solver` in each of so many substeps.
template <class Solver>
Configuration by_substeps(std::string name, int most, Solver solver) {
  return {
      name + ", substeps", "substeps", doubling(1, most), "β", betas, false, true, [=](int substeps, double beta) {
        return Setting{stepping(solver, beta, substeps)};
      }};
}

/// The same with the β that most people leave in place.
Configuration by_default(Configuration configuration) {
  configuration.name += ", defaults";
  configuration.tunings = {0.2};
  configuration.defaults = true;
  return configuration;
}

std::vector<Configuration> make_configurations() {
  const auto gauss_seidel = by_sweeps("Gauss–Seidel", 1024, [](int sweeps) { return GaussSeidel{sweeps}; });
  const auto direct = by_substeps("direct", 256, Direct{});
  return {
      gauss_seidel,
      by_default(gauss_seidel),
      by_substeps("Gauss–Seidel", 256, GaussSeidel{1}),
      by_sweeps("Jacobi", 1024, [](int sweeps) { return Jacobi{.sweeps = sweeps, .relaxation = 0.5}; }),
      by_sweeps("conjugate sweeps", 1024,
                [](int sweeps) { return ConjugateSweeps{.sweeps = sweeps, .tolerance = 0}; }),
      direct,
      by_default(direct),
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
