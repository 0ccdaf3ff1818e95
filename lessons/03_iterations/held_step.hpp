#pragma once

#include "lessons/03_iterations/knobs.hpp"

#include "lessons/scenes/chain.hpp"
#include "solver/rows/prepared.hpp"

namespace byhand::iterations {

/// One time step of a chain that hangs at rest, held where gravity is in V and the rows are written, but none is
/// solved; b = 0 and λ = 0. Joints are counted from the top.
class HeldStep {
 public:
  HeldStep(const ChainOptions& chain, double h, const RowSolver& solver = GaussSeidel{.warm_start = false});

  /// Solves the next row in the order of the solver: (17), then (20). After the last one comes the first.
  void solve_row();
  void solve_sweep();
  /// All that the solver does in one step.
  void solve();

  /// λ of each joint [N s/m]; negative where the rod pulls.
  std::vector<double> lambda() const;
  /// What each joint carries, as a share of the whole chain's weight: the force -λL/h over that.
  std::vector<double> shares() const;
  /// How fast each link is getting longer, JV/L [m/s].
  std::vector<double> errors() const;
  /// The largest of those by size [m/s].
  double error() const;
  /// How fast each bob moves downwards [m/s].
  std::vector<double> speeds() const;

  const Scene<PlaneParticle>& scene() const { return scene_; }
  const Work<PlaneParticle>& work() const { return work_; }
  /// Begins with this λ instead of 0; for solvers that start warm.
  void start_from(const std::vector<double>& lambda);

 private:
  ChainOptions chain_;
  double h_;
  RowSolver solver_;
  Scene<PlaneParticle> scene_;
  Work<PlaneParticle> work_;
  Prepared<PlaneParticle> prepared_;
  std::size_t next_ = 0;  // row to be solved
};

/// The largest error [m/s] that so many sweeps from λ = 0 leave.
template <class Solver>
double error_after(int sweeps, Solver solver, const ChainOptions& chain, double h) {
  solver.sweeps = sweeps;
  solver.warm_start = false;
  HeldStep step(chain, h, solver);
  step.solve();
  return step.error();
}

/// By what factor one sweep shrinks the error in the long run, measured where only the slowest wave is left: from
/// 4N² sweeps on, over 2N² of them (an even number, for Jacobi's errors alternate).
template <class Solver>
double measured_factor(const Solver& solver, const ChainOptions& chain, double h) {
  const int begin = 4 * chain.links * chain.links, span = begin / 2;
  return std::pow(error_after(begin + span, solver, chain, h) / error_after(begin, solver, chain, h), 1.0 / span);
}

/// How many sweeps of a cold Gauss–Seidel one more digit takes in the long run.
double measured_digit(const ChainOptions& chain, double h);

}  // namespace byhand::iterations
