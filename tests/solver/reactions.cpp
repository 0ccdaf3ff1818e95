#include <gtest/gtest.h>

#include "lessons/exact/hanging_chain.hpp"
#include "lessons/methods/method.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/solving.hpp"

// The force and the torques of a constraint, whatever method moves the scene.
namespace reactions_test {

using namespace byhand;

template <class M>
void expect_pull(const Reaction<M>& reaction, double tension, double tolerance) {
  const auto& [force, torque1, torque2] = reaction;
  EXPECT_LT((force / tension - Linear<M>::Unit(1)).norm(), tolerance) << "it pulls up";
  EXPECT_LT(torque1.norm() + torque2.norm(), tolerance);
}

/// The tensions of a hanging chain of rods, once it has run for a second, in units of what they are.
template <class Method>
void expect_tensions(const Method& method, double tolerance) {
  const ChainOptions chain{.links = 6, .length = 0.5, .mass = 2, .end_mass = 5};
  const auto tensions = hanging_chain_tensions(std::vector<double>{2, 2, 2, 2, 2, 5}, 9.81);
  in_all_models([&]<class M>(Random&) {
    for (const auto& scene : {rod_chain<M>(chain), rod_chain<M, NormalisedDistance>(chain)}) {
      Simulation simulation{scene, method};
      run(simulation, 1, time_step);
      for (int i = 0; i < 6; ++i) {
        SCOPED_TRACE(testing::Message() << "rod " << i);
        expect_pull<M>(simulation.reaction(scene.entries()[i].id), tensions[i], tolerance);
      }
    }
  });
}

TEST(Reaction, OfAHangingChainIsTheWeightBelow) {
  expect_tensions(VelocityStepping{Direct{}}, 1e-11);
  expect_tensions(VelocityStepping{GaussSeidel{.sweeps = 1000}}, 1e-9);
  VelocityStepping cut{Direct{}};
  cut.substeps = 4;
  expect_tensions(cut, 1e-10);
  expect_tensions(Xpbd{}, 1e-6);
  expect_tensions(Rattle{}, 1e-10);
  expect_tensions(Accelerations{}, 1e-10);
}

/// A box of 2 kg, 3 m out along x from the wall in which it is clamped at the origin.
template <class M>
Scene<M> clamped_box(Random& random) {
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  Pose<M> pose = random.pose<M>();
  pose.position = 3 * Linear<M>::Unit(0);
  scene.add_body(pose, box<M>(2, Linear<M>::Constant(0.4)));
  scene.add(weld<M>(scene.bodies(), 0, 1, Linear<M>(Linear<M>::Zero())));
  return scene;
}
template <class M>
void expect_clamp(const Reaction<M>& reaction, double tolerance) {
  constexpr double weight = 2 * 9.81, out = 3;
  const auto& [force, torque1, torque2] = reaction;
  EXPECT_LT((force - weight * Linear<M>::Unit(1)).norm(), tolerance);
  EXPECT_LT(torque2.norm(), tolerance) << "it does not turn";
  const Angular<M> moment = -out * weight * Angular<M>::Unit(M::angular - 1);
  EXPECT_LT((torque1 - moment).norm(), tolerance);
}
template <class Method>
void expect_clamped_box(const Method& method, double tolerance) {
  in_both_bodies([&]<class M>(Random& random) {
    Simulation simulation{clamped_box<M>(random), method};
    run(simulation, 1, time_step);
    expect_clamp<M>(simulation.reaction(simulation.scene.entries()[0].id), tolerance);
  });
}

TEST(Reaction, OfAClampedBoxIsItsWeightAndItsMoment) {
  expect_clamped_box(VelocityStepping{Direct{}}, 1e-9);
  expect_clamped_box(VelocityStepping{GaussSeidel{}}, 1e-9);
  expect_clamped_box(Rattle{}, 1e-9);
  expect_clamped_box(Accelerations{}, 1e-9);
  // C = 0 to rounding, 4e-16 m, is a force of 2 kg times that over the square of a substep of 1/1200 s.
  expect_clamped_box(Xpbd{}, 1e-7);
}

/// A rod of 2 m and 3 kg that is hinged by one end and let go level: its hinge carries a quarter of its weight,
/// for W - F = m α l/2 and α = 3g/2l.
template <class M>
void expect_quarter(const Reaction<M>& reaction, double tolerance) {
  constexpr double weight = 3 * 9.81;
  const auto& [force, torque1, torque2] = reaction;
  EXPECT_LT((force / weight - 0.25 * Linear<M>::Unit(1)).norm(), tolerance);
  // On the rod the hinge pushes 1 m to the left of its centre; the ground has its centre in the hinge.
  EXPECT_LT((torque2 / weight + 0.25 * Angular<M>::Unit(M::angular - 1)).norm(), tolerance);
  EXPECT_LT(torque1.norm(), tolerance * weight);
}
template <class Method>
void expect_quarter_of_the_weight(const Method& method, double tolerance) {
  in_both_bodies([&]<class M>(Random&) {
    Scene<M> scene = hinged_rod<M>(std::acos(-1.0) / 2, 2, 3);
    const int hinge = scene.entries()[0].id;
    Simulation simulation{scene, method};
    simulation.step(1e-3);
    expect_quarter<M>(simulation.reaction(hinge), tolerance);
  });
}

TEST(Reaction, OfAHingeIsAQuarterOfALevelRodsWeight) {
  expect_quarter_of_the_weight(VelocityStepping{Direct{}, NoDriftCure{}}, 1e-11);
  expect_quarter_of_the_weight(Accelerations{Scheme::explicit_euler}, 1e-11);
  // The rod turns by αh²/2 = 7e-6 within the step, and C = 0 to rounding is 1e-16 m of its 5e-6 m.
  expect_quarter_of_the_weight(Rattle{}, 1e-4);
  expect_quarter_of_the_weight(Xpbd{1, 30}, 1e-4);
}

template <class Method>
void expect_weight_of_a_box(const Method& method, double tolerance) {
  constexpr double weight = 9.81;
  in_both_bodies([&]<class M>(Random&) {
    Scene<M> scene = bodies_alone(stack<M>(1));
    for (int corner = 0; corner < 2 * (M::linear - 1); ++corner) {
      Linear<M> point = (corner % 2 - 0.5) * Linear<M>::Unit(0);
      if constexpr (M::linear == 3) point.z() = corner / 2 - 0.5;
      scene.add(Contact<M>{.at = between<M>(scene.bodies(), 0, point, 1, point), .normal = Linear<M>::Unit(1)});
    }
    Simulation simulation{scene, method};
    run(simulation, 2, time_step);
    Linear<M> force = Linear<M>::Zero();
    Angular<M> torque1 = Angular<M>::Zero(), torque2 = Angular<M>::Zero();
    for (const auto& entry : simulation.scene.entries()) {
      const Reaction<M> found = simulation.reaction(entry.id);
      force += found.force;
      torque1 += found.torque1;
      torque2 += found.torque2;
    }
    EXPECT_LT((force / weight - Linear<M>::Unit(1)).norm(), tolerance);
    EXPECT_LT(torque2.norm() / weight, tolerance);
    // The ground's centre is the origin; the two points of a contact part by what the method leaves.
    const Linear<M>& out = simulation.scene.bodies().pose[1].position;
    EXPECT_LT((torque1 + torque2 + cross(out, force)).norm() / weight, 2 * tolerance);
  });
}

TEST(Reaction, OfTheContactsOfABoxIsItsWeight) {
  expect_weight_of_a_box(VelocityStepping{}, 1e-9);
  expect_weight_of_a_box(VelocityStepping{GaussSeidel{}, SplitImpulse{}}, 1e-9);
  expect_weight_of_a_box(Xpbd{}, 1e-6);
}

}  // namespace reactions_test
