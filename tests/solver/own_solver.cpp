#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/advance.hpp"
#include "solver/measure.hpp"
#include "solver/rows/gauss_seidel.hpp"
#include "solver/rows/operators.hpp"

// A row solver that a program adds is one struct: the step asks it and knows none by name.
namespace byhand {
namespace own_solver_test {

/// Steepest descent: the rows' own errors are the direction, and it goes as far as the error falls,
/// α = (r·r)/(r·(A + γ)r), for rows without bounds.
struct SteepestDescent {
  int iterations = 100;  // >= 1

  template <class M>
  struct Work {
    std::vector<double> error, product;
    std::vector<Velocity<M>> V;
    int solved = 0;  // how often it was asked to
  };
  static constexpr bool holds_bounds = false;
  Layout layout() const { return Layout::reverse; }

  template <class M>
  Solution solve(System<M>& system, Bodies<M>& bodies, Work<M>& work, Begin begin) const {
    ++work.solved;
    work.error.resize(system.rows());
    work.product.resize(system.rows());
    work.V.resize(bodies.size());
    begin_sweeps(system, true, begin, bodies);
    for (int i = 0; i < iterations; ++i) {
      errors_of(system, bodies.velocity, system.lambda, work.error);
      multiply(system, work.error, work.V, work.product);
      double square = 0, curvature = 0;
      for (int k = 0; k < system.rows(); ++k) {
        square += work.error[k] * work.error[k];
        curvature += work.error[k] * work.product[k];
      }
      if (!(curvature > 0)) break;
      for (double& error : work.error) error *= -square / curvature;
      for (int k = 0; k < system.rows(); ++k) system.lambda[k] += work.error[k];
      apply_all(system, work.error, bodies.velocity);
    }
    return {.passes = iterations};
  }
};

void require_valid(const SteepestDescent& solver) {
  require(solver.iterations >= 1, "number of iterations", solver.iterations, "at least 1");
}

using OwnStepping = VelocitySteppingWith<SteepestDescent, Baumgarte>;

TEST(OwnSolver, OfOneStructComesToTheDirectSolvesVelocities) {
  const Scene<PlaneBody> chain = pinned_chain<PlaneBody>({.links = 4, .angle = 1});
  Simulation<PlaneBody, OwnStepping> own{chain, {.solver = {3000}, .drift = {}}};
  Simulation<PlaneBody> direct{chain, {Direct{}, Baumgarte{}}};
  for (int i = 0; i < 20; ++i) own.step(1.0 / 60), direct.step(1.0 / 60);
  for (int i = 0; i < chain.bodies().size(); ++i)
    EXPECT_LE((own.scene.bodies().velocity[i] - direct.scene.bodies().velocity[i]).norm(), 1e-9);
}

TEST(OwnSolver, IsAskedForItsLayoutKeepsItsWorkAndCountsItsPasses) {
  Simulation<PlaneBody, OwnStepping> own{pinned_chain<PlaneBody>({.links = 4, .angle = 1}),
                                         {.solver = {7}, .drift = {}}};
  own.step(1.0 / 60);
  own.step(1.0 / 60);
  EXPECT_EQ(std::any_cast<SteepestDescent::Work<PlaneBody>&>(own.work.solver).solved, 2);
  EXPECT_EQ(own.work.row_solves, 2 * 7 * own.work.system.rows());
  EXPECT_GT(own.work.system.row_of[0], own.work.system.row_of[3]) << "reversed";
}

TEST(OwnSolver, ThatHoldsNoBoundsIsRefusedContacts) {
  Simulation<PlaneBody, OwnStepping> own{stack(2), {.solver = {}, .drift = {}}};
  EXPECT_NE(refusal(own.scene, own.method), "");
  EXPECT_THROW(own.step(1.0 / 60), std::invalid_argument);
}

TEST(OwnSolver, IsHeldToItsRange) {
  Simulation<PlaneBody, OwnStepping> own{pinned_chain<PlaneBody>({.links = 1}), {.solver = {0}, .drift = {}}};
  EXPECT_THROW(own.step(1.0 / 60), std::invalid_argument);
}

TEST(OwnSolver, StandsInAListWithThoseOfTheLibrary) {
  using Listed = VelocitySteppingWith<std::variant<GaussSeidel, SteepestDescent>, DriftCure>;
  const Scene<PlaneParticle> chain = rod_chain<PlaneParticle>({.links = 3, .angle = 1});
  Simulation<PlaneParticle, Listed> simulation{chain, {SteepestDescent{2000}, NoDriftCure{}}};
  simulation.step(1.0 / 60);
  EXPECT_LE(residual(simulation.work.system, simulation.scene.bodies().velocity), 1e-9);
  simulation.method.solver = GaussSeidel{2000};
  simulation.step(1.0 / 60);
  EXPECT_LE(residual(simulation.work.system, simulation.scene.bodies().velocity), 1e-9);
}

}  // namespace own_solver_test
}  // namespace byhand
