#include <gtest/gtest.h>

#include <functional>

#include "lessons/scenes/chain.hpp"
#include "solver/constraints/friction.hpp"
#include "tests/solver/solving.hpp"

// What no method may change: momentum, and the answer when the same scene is looked at from elsewhere.
namespace invariance_test {

using namespace byhand;

/// Five free bodies that fly apart on rods, a pin and a contact with friction.
template <class M>
Scene<M> cluster(Random& random, bool bounded = true) {
  Scene<M> scene;
  scene.gravity.setZero();
  for (int i = 0; i < 5; ++i) scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
  for (int i = 0; i < 3; ++i) {
    const Distance<M> rod{{i, i + 1, random.arms<M>()}};
    const double now =
        rod.at.template separation<double>(scene.bodies().pose[i], scene.bodies().pose[i + 1]).norm();
    scene.add(Distance<M>{rod.at, now});
  }
  if constexpr (M::angular > 0) scene.add(pin<M>(scene.bodies(), 3, 4, Linear<M>(random.vector<M::linear>(2))));
  if (!bounded) return scene;
  // Contacts press along the line between two points, or at one point: else a pair of opposite impulses has a
  // moment of its own.
  if constexpr (M::angular > 0) {
    const Linear<M> point = random.vector<M::linear>(2), n = random.direction<M>();
    const auto at = between<M>(scene.bodies(), 0, point, 4, point);
    const int contact = scene.add(Contact<M>{at, n});
    scene.add(Friction<M>{at, tangents_of<M>(n), 0.5, contact});
  } else {
    const Linear<M> apart = scene.bodies().pose[4].position - scene.bodies().pose[0].position;
    scene.add(Contact<M>{{0, 4}, apart.normalized()});
  }
  return scene;
}

const std::vector<RowSolver>& sweeping_solvers() {
  static const std::vector<RowSolver> solvers{
      GaussSeidel{1}, GaussSeidel{10, false, SweepOrder::reverse}, GaussSeidel{7, true, SweepOrder::coloured},
      GaussSeidel{3, true, SweepOrder::natural, BlockSolve::row_by_row, 1.3}, Jacobi{5, true, 0.5}};
  return solvers;
}
const std::vector<RowSolver>& direct_solvers() {
  static const std::vector<RowSolver> solvers{Direct{}, Direct{Factorisation::dense}};
  return solvers;
}

TEST_IN_ALL_MODELS(Momentum, IsKeptByEverySolverAfterAnyNumberOfSweeps, 10) {
  const auto expect_kept = [](Scene<M> scene, const RowSolver& solver) {
    const auto linear = linear_momentum(scene.bodies());
    const auto angular = angular_momentum(scene.bodies());
    Work<M> work;
    const auto poses = scene.bodies().pose;
    advance(scene, {.solver = solver, .drift = NoDriftCure{}, .gyroscopic = Gyroscopic::none}, time_step, work);
    EXPECT_GT(largest(work.system.lambda), 0.01) << "something was solved";
    EXPECT_LE(difference(linear_momentum(scene.bodies()), linear), 1e-11);
    // Of the velocities at the poses where the rows were written: moving the poses is not the solver's.
    scene.state().pose = poses;
    EXPECT_LE(difference(angular_momentum(scene.bodies()), angular), 1e-11);
  };
  const auto free = cluster<M>(random, false), bounded = cluster<M>(random);
  for (const auto& solver : sweeping_solvers()) expect_kept(bounded, solver);
  for (const auto& solver : direct_solvers()) expect_kept(free, solver);
}

TEST_IN_ALL_MODELS(LinearMomentum, IsKeptOverASecondWithDriftAndItsCure) {
  for (const auto& solver : sweeping_solvers()) {
    auto scene = cluster<M>(random);
    const auto before = linear_momentum(scene.bodies());
    Work<M> work;
    for (int i = 0; i < 60; ++i) advance(scene, {solver}, time_step, work);
    EXPECT_LE(difference(linear_momentum(scene.bodies()), before),
              1e-12 * (1 + std::sqrt(kinetic_energy(scene.bodies()))) * 60);
  }
}

TEST(AngularMomentum, OfParticlesIsKeptOverASecond) {
  in_models<PlaneParticle, SpaceParticle>([]<class M>(Random& random) {
    for (const auto& solver : direct_solvers()) {
      auto scene = cluster<M>(random, false);
      const auto before = angular_momentum(scene.bodies());
      Work<M> work;
      for (int i = 0; i < 60; ++i) {
        advance(scene, {solver}, time_step, work);
        EXPECT_LE(difference(angular_momentum(scene.bodies()), before), 1e-10);
      }
    }
  });
}

/// A change of viewpoint: where a point and a direction of the scene are in the new one.
template <class M>
struct View {
  Rotation<M> turn;
  Eigen::Matrix<double, M::linear, M::linear> matrix;
  Linear<M> shift;

  explicit View(Random& random) : shift(random.vector<M::linear>(10)) {
    if constexpr (M::linear == 2) {
      const PlaneRotation<> r = plane_rotation(random.uniform(-3, 3));
      matrix << r.cos, -r.sin, r.sin, r.cos;
      if constexpr (M::angular == 1) turn = r;
    } else {
      const Eigen::Quaterniond q = Eigen::Quaterniond(random.vector<4>(1)).normalized();
      matrix = q.toRotationMatrix();
      if constexpr (M::angular == 3) turn = q;
    }
  }

  Pose<M> of(Pose<M> pose) const {
    pose.position = matrix * pose.position + shift;
    if constexpr (M::angular > 0) pose.rotation = turn * pose.rotation;
    return pose;
  }
  Velocity<M> of(Velocity<M> V) const {
    V.template head<M::linear>() = (matrix * V.template head<M::linear>()).eval();
    if constexpr (M::angular == 3) V.template tail<3>() = (matrix * V.template tail<3>()).eval();
    return V;
  }
  Scene<M> of(Scene<M> scene) const {
    for (auto& pose : scene.state().pose) pose = of(pose);
    for (auto& V : scene.state().velocity) V = of(V);
    scene.gravity = matrix * scene.gravity;
    scene.template change_all<Contact>([&](auto& contact) { contact.normal = (matrix * contact.normal).eval(); });
    scene.template change_all<Friction>(
        [&](auto& friction) { friction.tangents = (matrix * friction.tangents).eval(); });
    return scene;
  }
};

TEST_IN_ALL_MODELS(Translation, AndRotationOfTheWholeSceneChangeOnlyTheView, 5) {
  const View<M> view(random);
  for (const auto& solver : sweeping_solvers()) {
    auto scene = cluster<M>(random);
    if (!std::get_if<Jacobi>(&solver)) scene.gravity = random.vector<M::linear>(10);
    // A pin solved row by row depends on its axes, as any order of rows does.
    if (const auto* sweeps = std::get_if<GaussSeidel>(&solver);
        sweeps && sweeps->block_solve == BlockSolve::row_by_row && M::angular > 0)
      continue;
    auto elsewhere = view.of(scene);
    Work<M> work, work_elsewhere;
    for (int i = 0; i < 5; ++i) {
      advance(scene, {solver}, time_step, work);
      advance(elsewhere, {solver}, time_step, work_elsewhere);
    }
    for (int i = 0; i < scene.bodies().size(); ++i) {
      const Velocity<M> expected = view.of(scene.bodies().velocity[i]);
      EXPECT_LE(difference(elsewhere.bodies().velocity[i], expected), 1e-8 * (1 + expected.norm()));
      EXPECT_LE(difference(elsewhere.bodies().pose[i].position, view.of(scene.bodies().pose[i]).position), 1e-8);
    }
  }
}

/// The cluster's rods with both bodies of each in the other order.
template <class M>
Scene<M> rods_of(const Scene<M>& scene, bool swapped) {
  Scene<M> rods = bodies_alone(scene);
  for (Distance<M> rod : scene.template all<Distance>()) {
    if (swapped) {
      std::swap(rod.at.body1, rod.at.body2);
      if constexpr (M::angular > 0) std::swap(rod.at.arms.first, rod.at.arms.second);
    }
    rods.add(rod);
  }
  return rods;
}

TEST_IN_ALL_MODELS(SwappedBodies, GiveTheMirroredAnswer, 10) {
  const auto scene = cluster<M>(random);
  for (const auto& solver : {sweeping_solvers()[0], sweeping_solvers()[4], direct_solvers()[0]}) {
    const auto straight = solved(rods_of(scene, false), any(solver)),
               swapped = solved(rods_of(scene, true), any(solver));
    EXPECT_LE(difference(straight.velocity, swapped.velocity), 1e-11);
    EXPECT_LE(difference(straight.lambda, swapped.lambda), 1e-11) << "a rod pulls both ends alike";
  }
  if constexpr (M::angular > 0) {
    Pin<M> pin = scene.template all<Pin>()[0], turned = pin;
    std::swap(turned.at.body1, turned.at.body2);
    std::swap(turned.at.arms.first, turned.at.arms.second);
    Scene<M> straight = bodies_alone(scene), swapped = straight;
    straight.add(pin);
    swapped.add(turned);
    auto expected = solved(straight, GaussSeidel{1}), answer = solved(swapped, GaussSeidel{1});
    for (double& lambda : expected.lambda) lambda = -lambda;
    EXPECT_LE(difference(expected.lambda, answer.lambda), 1e-11) << "the impulse on the other body";
    EXPECT_LE(difference(expected.velocity, answer.velocity), 1e-11);
  }
}

TEST_IN_ALL_MODELS(Masses, ScaledTogetherScaleTheImpulsesAndNotTheMotion, 10) {
  for (const auto& solver : sweeping_solvers()) {
    const auto scene = cluster<M>(random);
    auto heavy = scene;
    for (int i = 0; i < heavy.bodies().size(); ++i) {
      InverseMass<M> mass = heavy.bodies().inverse_mass[i];
      mass.linear /= 8;
      if constexpr (M::angular > 0) mass.angular /= 8;
      heavy.set_mass(i, mass);
    }
    const auto light_answer = solved(scene, any(solver)), heavy_answer = solved(heavy, any(solver));
    EXPECT_LE(difference(light_answer.velocity, heavy_answer.velocity), 1e-10);
    auto expected = light_answer.lambda;
    for (double& lambda : expected) lambda *= 8;
    EXPECT_LE(difference(heavy_answer.lambda, expected), 1e-10 * (1 + largest(expected)));
  }
}

TEST_IN_ALL_MODELS(Boost, OfTheWholeSceneRidesAlong, 5) {
  const Linear<M> boost = random.vector<M::linear>(5);
  for (const auto& solver : sweeping_solvers()) {
    auto scene = cluster<M>(random), riding = scene;
    for (auto& V : riding.state().velocity) V.template head<M::linear>() += boost;
    Work<M> work, riding_work;
    for (int i = 0; i < 5; ++i) {
      advance(scene, {solver}, time_step, work);
      advance(riding, {solver}, time_step, riding_work);
    }
    for (int i = 0; i < scene.bodies().size(); ++i) {
      Velocity<M> expected = scene.bodies().velocity[i];
      expected.template head<M::linear>() += boost;
      EXPECT_LE(difference(riding.bodies().velocity[i], expected), 1e-8 * (1 + expected.norm()));
    }
  }
}

}  // namespace invariance_test
