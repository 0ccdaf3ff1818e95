#include <gtest/gtest.h>

#include "lessons/scenes/box_pile.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "tests/solver/solving.hpp"

// Every way to solve rows against one exact answer: without bounds the dense direct solve, with bounds conjugate
// sweeps that go on until nothing changes.
namespace row_solvers_test {

using namespace byhand;
using Rods = Scene<PlaneParticle>;

Rods hanging(int links, double end_mass = 1) {
  return rod_chain<PlaneParticle, NormalisedDistance>({.links = links, .end_mass = end_mass});
}

const AnyRowSolver patient[] = {
    GaussSeidel{3000},
    GaussSeidel{1500, true, SweepOrder::symmetric},
    GaussSeidel{.sweeps = 3000, .order = SweepOrder::coloured, .relaxation = 1.3},
    Direct{},
    ConjugateSweeps{.sweeps = 3000, .tolerance = 1e-13},
    ConjugateSweeps{.sweeps = 1500, .order = SweepOrder::symmetric, .tolerance = 1e-13},
    ByGraph{.loops = {.sweeps = 3000, .tolerance = 1e-13}},
    ConjugateGradients{.iterations = 300, .tolerance = 1e-13},
    AcceleratedGradient{.iterations = 5000, .tolerance = 1e-12},
};

TEST_IN_ALL_MODELS(RowSolvers, MeetTheDenseDirectSolveOnEveryGraph, 4) {
  const auto scene = random_graph<M>(random, 8, 12);
  const auto exact = solved(scene, Direct{Factorisation::dense});
  for (const AnyRowSolver& solver : patient) {
    const auto answer = solved(scene, solver);
    EXPECT_LE(difference(answer.velocity, exact.velocity), 1e-9 * (1 + largest(exact.velocity)))
        << "solver " << solver.index();
    EXPECT_LE(difference(answer.lambda, exact.lambda), 1e-9 * (1 + largest(exact.lambda)))
        << "solver " << solver.index();
  }
}

TEST(ConjugateGradients, SolveAChainInAsManyIterationsAsItHasLinksAndNoFewer) {
  for (const int links : {2, 5, 10, 30}) {
    const auto chain = hanging(links);
    const auto exact = solved(chain, Direct{Factorisation::dense});
    const auto error = [&](int iterations) {
      return difference(solved(chain, ConjugateGradients{iterations, 0, false}).velocity, exact.velocity);
    };
    EXPECT_LE(error(links), 1e-13 * links) << links;
    EXPECT_GE(error(links - 1), 1e-4) << links;
  }
}

TEST(ConjugateGradients, StopOnTheirToleranceAndAtOnceWhereNothingIsLeft) {
  auto scene = hanging(40);
  Work<PlaneParticle> work;
  advance(scene, AnyStepping{ConjugateGradients{.iterations = 1000, .tolerance = 1e-6}, NoDriftCure{}}, time_step,
          work);
  EXPECT_LE(residual(work.system, scene.bodies().velocity), 1.01e-6);
  EXPECT_LE(work.row_solves, 41 * 40);
  for (int i = 0; i < 5; ++i)
    advance(scene, AnyStepping{ConjugateGradients{.iterations = 1000, .tolerance = 1e-6}, NoDriftCure{}},
            time_step, work);
  const long long before = work.row_solves;
  advance(scene, AnyStepping{ConjugateGradients{.iterations = 1000, .tolerance = 1e-5}, NoDriftCure{}}, time_step,
          work);
  EXPECT_EQ(work.row_solves, before) << "a warm start has the answer";
}

TEST(ConjugateGradients, StayWithTheAnswerHoweverManyIterationsMayFollow) {
  Simulation<PlaneParticle, AnyStepping> swinging{
      rod_chain<PlaneParticle, NormalisedDistance>({.links = 2, .angle = 1.57}),
      AnyStepping{ConjugateGradients{.iterations = 1000, .tolerance = 0}}};
  Simulation<PlaneParticle, AnyStepping> exact = swinging;
  exact.method.solver = Direct{};
  for (int i = 0; i < 60; ++i) {
    swinging.step(time_step);
    exact.step(time_step);
    EXPECT_LE(difference(numbers_of<PlaneParticle>(swinging.scene.bodies().velocity),
                         numbers_of<PlaneParticle>(exact.scene.bodies().velocity)),
              1e-9)
        << "step " << i;
  }
}

TEST(ConjugateGradients, RefuseScenesWithBoundsInOneSentence) {
  Scene<PlaneBody> boxes = stack(1);
  Scene<PlaneBody> contact;
  contact.add_body({0, 0}, fixed<PlaneBody>());
  contact.add_body({0, 1}, ball<PlaneBody>(1, 1));
  EXPECT_EQ(refusal(contact, AnyStepping{ConjugateGradients{}}), "");
  contact.add(Contact<PlaneBody>{{0, 1}});
  EXPECT_NE(refusal(contact, AnyStepping{ConjugateGradients{}}), "");
  EXPECT_EQ(refusal(boxes, AnyStepping{GaussSeidel{}}), "");
  Work<PlaneBody> work;
  try {
    advance(boxes, AnyStepping{ConjugateGradients{}}, time_step, work);
    FAIL();
  } catch (const std::invalid_argument& error) {
    EXPECT_EQ(error.what(), refusal(boxes, AnyStepping{ConjugateGradients{}}));
  }
}

// 1 - ρ of Gauss–Seidel on a chain is θ², θ = π/2N. One sweep forth and back has M = A + L D⁻¹ Lᵀ for its matrix;
// on the slowest wave the second part is ½ (one row's share of a row before it), and A is θ²: 1 - ρ = 2θ², the
// same for each of its two sweeps.
TEST(SymmetricSweeps, LeaveOfASlowWaveWhatTwoSweepsLeave) {
  const double pi = std::acos(-1.0);
  for (const int links : {10, 20, 40}) {
    const auto chain = hanging(links);
    const auto error = [&](int sweeps) {
      return solved(chain, GaussSeidel{sweeps, false, SweepOrder::symmetric}, NoDriftCure{}).residual;
    };
    const int settled = links * links / 2;
    const double rate = std::pow(error(settled + 20) / error(settled), 1.0 / 20);
    EXPECT_NEAR((1 - rate) / (2 * std::pow(pi / (2 * links), 2)), 1, 2.0 / links) << links;
  }
}

TEST(SymmetricSweeps, CountAsTwo) {
  auto once = hanging(7), twice = once;
  Work<PlaneParticle> work1, work2;
  advance(once, AnyStepping{GaussSeidel{3, false, SweepOrder::symmetric}}, time_step, work1);
  advance(twice, AnyStepping{GaussSeidel{3, false}}, time_step, work2);
  EXPECT_EQ(work1.row_solves, 2 * work2.row_solves);
}

/// A few boxes of random sides and masses that lean on each other and on the ground, struck at random.
Scene<PlaneBody> random_boxes(Random& random, double friction) {
  Scene<PlaneBody> scene;
  add_ground(scene, {random.uniform(0, friction)});
  const int count = 2 + random.index(4);
  double top = 0;
  for (int i = 0; i < count; ++i) {
    const Linear<PlaneBody> sides(random.uniform(0.5, 2), random.uniform(0.3, 1));
    Pose<PlaneBody> pose;
    const bool beside = random.uniform(0, 1) < 0.4;
    pose.position = {random.uniform(-0.4, 0.4) + (beside ? 1.5 : 0.0), (beside ? 0.0 : top) + 0.5 * sides.y()};
    if (!beside) top += sides.y();
    const int box = add_box(scene, pose, random.uniform(0.5, 5), sides, {random.uniform(0, friction)});
    scene.state().velocity[box] = 0.3 * random.velocity<PlaneBody>();
  }
  return scene;
}

const AnyRowSolver with_bounds[] = {
    GaussSeidel{.sweeps = 1000000, .tolerance = 1e-13},
    GaussSeidel{.sweeps = 500000, .order = SweepOrder::symmetric, .tolerance = 1e-13},
    AcceleratedGradient{.iterations = 100000, .tolerance = 1e-12}};

/// Whether no row of the faces' ends repeats others: the rank of all J that can move something is their number.
bool independent(const Scene<PlaneBody>& scene) {
  Scene<PlaneBody> copy = scene;
  Work<PlaneBody> work;
  advance(copy, AnyStepping{GaussSeidel{1}}, time_step, work);
  Eigen::MatrixXd J(0, 3 * scene.bodies().size());
  for (const auto& face : std::get<block_type<PlaneBody, 3, Bound::manifold>()>(work.system.blocks))
    for (int k = 0; k < 2; ++k) {
      Eigen::RowVectorXd row = Eigen::RowVectorXd::Zero(J.cols());
      if (face.moves1) row.segment<3>(3 * face.body1) = face.J.matrix.row(k).head<3>();
      if (face.moves2) row.segment<3>(3 * face.body2) = face.J.matrix.row(k).tail<3>();
      if (row.isZero(0)) continue;  // the second end of a point
      J.conservativeResize(J.rows() + 1, Eigen::NoChange);
      J.bottomRows<1>() = row;
    }
  return J.rows() == 0 || Eigen::FullPivLU<Eigen::MatrixXd>(J).rank() == J.rows();
}

// Without friction the velocities are those of a convex problem, and there is one answer. A direct solve may
// refuse it only where boxes lie on more points than they need; a regularisation of 1e-9 then finds it but for γλ,
// which is 1e-9 of the few m/s that the rows stop, times a condition of less than 1e3.
TEST(RowSolvers, MeetTheReferenceOnRandomBoxesWithoutFriction) {
  int direct = 0, refused = 0;
  in_models<PlaneBody>(
      [&]<class M>(Random& random) {
        const Scene<PlaneBody> scene = random_boxes(random, 0);
        const auto exact = solved(scene, exact_sweeps());
        EXPECT_TRUE(exact.converged);
        for (const AnyRowSolver& solver : with_bounds)
          EXPECT_LE(difference(solved(scene, solver).velocity, exact.velocity), 1e-9)
              << "solver " << solver.index();
        try {
          EXPECT_LE(difference(solved(scene, Direct{.tolerance = 1e-12}).velocity, exact.velocity), 1e-9);
          ++direct;
        } catch (const SingularSystem&) {
          EXPECT_FALSE(independent(scene));
          ++refused;
        }
        const Direct regularised{.regularisation = 1e-9, .rounds = 100, .tolerance = 1e-12};
        EXPECT_LE(difference(solved(scene, regularised).velocity, exact.velocity), 1e-6);
      },
      40);
  EXPECT_GE(direct, 20);
  EXPECT_GE(refused, 5) << "some lie on more points than they need";
}

// Coulomb's law may have several answers where boxes wedge: every solver finds one, and mostly it is the same.
TEST(RowSolvers, EachFindAnAnswerOnRandomBoxesWithFriction) {
  int same = 0, others = 0;
  in_models<PlaneBody>(
      [&]<class M>(Random& random) {
        const Scene<PlaneBody> scene = random_boxes(random, 0.8);
        const auto exact = solved(scene, exact_sweeps());
        for (const AnyRowSolver& solver : with_bounds) {
          const auto answer = solved(scene, solver);
          EXPECT_TRUE(answer.converged) << "solver " << solver.index();
          EXPECT_LE(answer.residual, 1e-11 * (1 + largest(answer.lambda))) << "solver " << solver.index();
          ++(difference(answer.velocity, exact.velocity) <= 1e-9 ? same : others);
        }
      },
      40);
  EXPECT_GE(same, 3 * others);
}

TEST(RowSolvers, MeetTheReferenceOnRandomPiles) {
  for (int seed = 0; seed < 8; ++seed) {
    Simulation<PlaneBody, AnyStepping> pile{
        box_pile<PlaneBody>(seed, {.count = 6, .speed = 3, .decades = 1, .surface = {}}),
        AnyStepping{GaussSeidel{50}}};
    for (int i = 0; i < 90; ++i) pile.step(time_step);
    const auto exact = solved(pile.scene, exact_sweeps());
    for (const AnyRowSolver& solver : {with_bounds[0], with_bounds[2]})
      EXPECT_LE(difference(solved(pile.scene, solver).velocity, exact.velocity), 1e-9)
          << "solver " << solver.index() << ", pile " << seed;
  }
}

TEST(AcceleratedGradient, KeepsEveryBoundAtWhateverIterationItStops) {
  for (int iterations = 1; iterations <= 12; ++iterations) {
    Scene<PlaneBody> scene = pyramid(5);
    kick(scene, 2);
    Work<PlaneBody> work;
    for (int i = 0; i < 20; ++i) {
      advance(scene, AnyStepping{AcceleratedGradient{.iterations = iterations}}, time_step, work);
      for (std::size_t k = 0; k < work.system.lambda.size(); k += 3) {
        const double* lambda = &work.system.lambda[k];
        ASSERT_GE(std::min(lambda[0], lambda[1]), 0);
        ASSERT_LE(std::abs(lambda[2]), work.system.upper[k] * (lambda[0] + lambda[1]) * (1 + 1e-12));
      }
    }
  }
}

// A momentum leaves 1 - 1/√κ of an error in each iteration (Y. Nesterov, 1983), where sweeps leave 1 - O(1/κ). Of
// a chain JM⁻¹Jᵀ has eigenvalues from (π/2N)² to 4: √κ = 4N/π, and from gh to the tolerance ε it takes √κ ln(gh/ε)
// iterations at most. No method that multiplies by A once can do with fewer than news needs along the chain: N.
TEST(AcceleratedGradient, TakesInProportionToAChainsLinksWhatSweepsTakeBySquare) {
  constexpr double tolerance = 1e-6;
  for (const int links : {10, 20, 40, 80, 160}) {
    auto scene = hanging(links);
    Work<PlaneParticle> work;
    advance(scene,
            AnyStepping{AcceleratedGradient{.iterations = 100000, .tolerance = tolerance, .warm_start = false}},
            time_step, work);
    const double push = 2 * (links - 1) * 9.81 * time_step;  // of the second rod, between two bobs
    EXPECT_LE(residual(work.system, scene.bodies().velocity), tolerance * push);
    const double iterations = static_cast<double>(work.row_solves) / links;
    const double root_of_condition = 4 * links / std::acos(-1.0);
    EXPECT_LE(iterations, root_of_condition * std::log(9.81 * time_step / (tolerance * push))) << links;
    EXPECT_GE(iterations, links) << links;
  }
}

/// Bodies of 1 g to 1 kg or 1 kg to 1 t, each pinned to one before it, and further pins that close loops. Each of
/// those may be there twice.
template <class M>
Scene<M> linkage(Random& random, int bodies, int loops, int times) {
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  const auto add_pin = [&](int body1, int body2) {
    scene.add(pin<M>(scene.bodies(), body1, body2, Linear<M>(random.vector<M::linear>(1))));
    return scene.count() - 1;
  };
  for (int i = 1; i <= bodies; ++i) {
    scene.add_body(Linear<M>(random.vector<M::linear>(1)),
                   box<M>(std::pow(10, random.uniform(-3, 3)), Linear<M>::Constant(0.5)));
    add_pin(random.index(i), i);
  }
  for (int i = 0; i < loops; ++i) {
    const int body = 1 + random.index(bodies - 1), at = add_pin(body, body + 1 + random.index(bodies - body));
    for (int again = 1; again < times; ++again) scene.add(Pin<M>(*scene.template get_if<Pin<M>>(at)));
  }
  return scene;
}
/// The largest separation of its pins in a second; infinite if the solver throws.
template <class M>
double largest_separation(const Scene<M>& scene, const AnyRowSolver& solver) {
  Simulation<M, AnyStepping> simulation{scene, {solver, Baumgarte{0.2}}};
  double largest = 0;
  try {
    for (int i = 0; i < 60; ++i) {
      simulation.step(time_step);
      largest = std::max(largest, position_error(simulation).max);
    }
  } catch (const SingularSystem&) {
    return std::numeric_limits<double>::infinity();
  }
  return largest;
}
// Some of them come to a singular pose within the second, where a direct solve throws and what follows is chance:
// there the choice may do worse than sweeps, but not on the whole.
TEST_IN_BOTH_BODIES(ByGraph, HoldsLinkagesWithLoopsAtLeastAsWellAsSweepsOrADirectSolve) {
  for (const int times : {1, 2}) {
    double logarithms = 0;  // of the separation in units of that of sweeps
    for (int draw = 0; draw < 50; ++draw) {
      const int bodies = 3 + random.index(10);
      const auto scene = linkage<M>(random, bodies, 1 + random.index(bodies * (M::dof - 1) / 5), times);
      const double chosen = largest_separation(scene, ByGraph{}), direct = largest_separation(scene, Direct{}),
                   sweeps = largest_separation(scene, ConjugateSweeps{});
      const double worst = std::isinf(direct) ? sweeps : std::max(direct, sweeps);
      // Of pins that are a metre apart neither holds any, and what follows is chance as well.
      EXPECT_LT(chosen, (std::isinf(direct) || worst > 1 ? 10 : 1.1) * worst) << "draw " << draw;
      logarithms += std::log(chosen / sweeps);
    }
    EXPECT_LT(std::exp(logarithms / 50), 0.6) << "each closing pin " << times << " times";
  }
}

TEST(ByGraph, ChoosesAsAfreshWhenTheSolverWasAnother) {
  Random random;
  auto scene = linkage<PlaneBody>(random, 6, 2, 1), fresh = scene;
  Work<PlaneBody> work, none;
  auto probe = scene;
  advance(probe, AnyStepping{GaussSeidel{.order = SweepOrder::coloured}}, time_step, work);
  std::fill(work.system.lambda.begin(), work.system.lambda.end(), 0.0);
  advance(scene, AnyStepping{ByGraph{}}, time_step, work);
  advance(fresh, AnyStepping{ByGraph{}}, time_step, none);
  EXPECT_EQ(scene.bodies().velocity, fresh.bodies().velocity);
}

TEST_IN_ALL_MODELS(Direct, GoesOnFromTheImpulsesThatStand, 5) {
  auto scene = random_graph<M>(random, 8, 12);
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense}) {
    const RowSolver direct = Direct{factorisation};
    Work<M> work;
    auto copy = scene;
    advance(copy, VelocityStepping{.solver = direct, .drift = NoDriftCure{}, .gyroscopic = Gyroscopic::none},
            time_step, work);
    auto& system = work.system;
    const auto V = copy.bodies().velocity;
    const auto lambda = system.lambda;
    solve_rows(direct, copy.state(), work, Begin::resume);
    EXPECT_LE(difference(system.lambda, lambda), 1e-10 * (1 + largest(lambda))) << "nothing is left to do";
    for (int i = 0; i < system.rows(); ++i) {
      system.bias[i] += random.uniform(-1, 1);
      system.gamma[i] = random.uniform(0.01, 0.1);
    }
    solve_rows(direct, copy.state(), work, Begin::resume);
    EXPECT_LE(residual(system, copy.bodies().velocity), 1e-9) << "another bias and softness";
  }
}

}  // namespace row_solvers_test
