#include <gtest/gtest.h>

#include "solver/constraints/hinge.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// What welds, sliders and hinges hold, and what they leave free.
namespace joints_hold_test {

using namespace byhand;
constexpr double h = 1.0 / 60, g = 9.81;

template <class M>
Velocity<M> velocity(const Linear<M>& v) {
  Velocity<M> V = Velocity<M>::Zero();
  V.template head<M::linear>() = v;
  return V;
}

TEST_IN_BOTH_BODIES(Weld, CarriesABoxByItsWeightAndItsMoment) {
  for (const RowSolver& solver : {RowSolver(Direct{}), RowSolver(GaussSeidel{.sweeps = 1})}) {
    Simulation<M> simulation{{}, {solver}};
    auto& scene = simulation.scene;
    scene.add_body(random.pose<M>(), fixed<M>());
    Pose<M> pose = random.pose<M>();
    pose.position = 3 * Linear<M>::Unit(0);
    scene.add_body(pose, box<M>(2, Linear<M>::Constant(0.4)));
    scene.add(weld<M>(scene.bodies(), 0, 1, Linear<M>(Linear<M>::Zero())));
    run(simulation, 5, h);
    EXPECT_LT((scene.bodies().pose[1].position - pose.position).norm(), 1e-12);
    Rows<M::dof> expected = Rows<M::dof>::Zero();
    expected[1] = 2 * g;  // along y, and about z, 3 m from the wall, where it is clamped
    expected[M::dof - 1] = 3 * 2 * g;
    for (int k = 0; k < M::dof; ++k) EXPECT_NEAR(force(simulation.work, 0, k), expected[k], 1e-9) << "row " << k;
  }
}

TEST_IN_BOTH_BODIES(Slider, LetsABoxFallAlongItAsIfNothingHeldIt, 5) {
  Simulation<M> simulation{{}, {Direct{}}};
  auto& scene = simulation.scene;
  scene.add_body(random.pose<M>(), fixed<M>());
  scene.add_body(random.pose<M>(), random.mass<M>());
  const Linear<M> axis = random.direction<M>(), start = scene.bodies().pose[1].position;
  const Pose<M> upright = scene.bodies().pose[1];
  scene.add(slider<M>(scene.bodies(), 0, 1, random.vector<M::linear>(1), axis));
  for (int n = 1; n <= 120; ++n) {
    simulation.step(h);
    const Linear<M> gone = -g * axis.y() * h * h * n * (n + 1) / 2 * axis;
    ASSERT_LT((scene.bodies().pose[1].position - start - gone).norm(), 1e-11);
  }
  const auto off = orientation<M>(scene.bodies(), 0, 1);
  EXPECT_LT(off.value(scene.bodies().pose[0], upright).norm(), 1e-12);
}

TEST(Hinge, IsACompoundPendulumsAxis) {
  using M = SpaceBody;
  Simulation<M> simulation{{}, {Direct{}, Baumgarte{0.2}}};
  simulation.method.gyroscopic = Gyroscopic::none;  // the hinge takes its moment
  auto& scene = simulation.scene;
  scene.add_body(Linear<M>(0, 0, 0), fixed<M>());
  Pose<M> pose;
  pose.position = {0.5, 0, 0};
  pose.rotation = space_rotation(Angular<M>(0.4, 0.3, -0.2));
  const auto mass = box<M>(2, Linear<M>(0.9, 0.3, 0.5));
  scene.add_body(pose, mass);
  scene.add(hinge(scene.bodies(), 0, 1, Linear<M>(0, 0, 0), Linear<M>(0, 0, 3)));
  // From rest only the moment about the axis counts: (I_zz + m a²) α = -m g a.
  simulation.step(h);
  const double moment = inertia<M>(mass, pose)(2, 2) + 2 * 0.25;
  EXPECT_NEAR(scene.bodies().velocity[1][5], -2 * g * 0.5 / moment * h, 1e-12);
  EXPECT_NEAR(scene.bodies().velocity[1].segment<2>(3).norm(), 0, 1e-12);
  // ω stays along z to rounding, and a turn about z keeps the axis: 300 steps of 2⁻⁵³. In the plane each step
  // moves the centre along its tangent, a(ωh)²/2 too far out, of which a share β comes back: a(ωh)²/2β is left at
  // most. ω is largest after a fall of a: ½ moment ω² = m g a.
  const double fastest_squared = 2 * 2 * g * 0.5 / moment;
  double farthest = 0;
  run(simulation, 5, h, [&] {
    const Linear<M> axis = rotate(scene.bodies().pose[1].rotation, scene.all<Hinge>()[0].axis);
    ASSERT_LT(axis.head<2>().norm(), 300 * 0x1p-53);
    const Linear<M> centre = scene.bodies().pose[1].position;
    ASSERT_LT(std::abs(centre.z()), 300 * 0x1p-53);
    farthest = std::max(farthest, std::abs(centre.norm() - 0.5));
  });
  const double law = 0.5 * fastest_squared * h * h / (2 * 0.2);
  EXPECT_LT(farthest, law);
  EXPECT_GT(farthest, 0.7 * law) << "the bottom is passed within the time that the correction takes";
}

/// What a scene of floating bodies has lost after 2 s, once a first step has brought V onto its joints.
struct Lost {
  double linear, angular;  // of the momenta
  double by_gaps;          // Σ |C||λ|: the most of it that a weld's two ends may make by being C apart
  double gap;              // at the end
};
template <class M>
Lost lost_after_two_seconds(Simulation<M> simulation, double step) {
  auto& scene = simulation.scene;
  const Linear<M> p = linear_momentum(scene.bodies());
  simulation.step(step);
  const auto L = angular_momentum(scene.bodies());
  double by_gaps = 0;
  run(simulation, 2, step, [&] {
    const Weld<M>& weld = scene.template all<Weld>()[0];
    const auto C = weld.template value<double>(scene.bodies().pose[1], scene.bodies().pose[2]);
    double lambda = 0;
    for (int k = 0; k < M::linear; ++k)
      lambda = std::hypot(lambda, force(simulation.work, 0, k) * simulation.work.h);
    by_gaps += 1.3 * C.template head<M::linear>().norm() * lambda;  // C from after the step: by (1 - β) less
  });
  return {(linear_momentum(scene.bodies()) - p).norm(), (angular_momentum(scene.bodies()) - L).norm(), by_gaps,
          position_error(scene).max};
}

// Impulses of joints are internal. A slider's act along one line even while it is off; those of a weld act C
// apart, and turn the whole by C × λ at most. What turns in space has its gyroscopic moment from an implicit Euler
// of order one. The gap that is left is what a step turns too far out, by (ωh)², over β: of order two.
TEST_IN_BOTH_BODIES(Joints, KeepTheMomentumOfWhatFloats, 5) {
  Simulation<M> simulation{{}, {Direct{}, Baumgarte{0.2}}};
  auto& scene = simulation.scene;
  scene.gravity.setZero();
  simulation.method.gyroscopic = Gyroscopic::implicit;
  for (int i = 0; i < 3; ++i) scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
  scene.add(slider<M>(scene.bodies(), 0, 1, random.vector<M::linear>(1), random.direction<M>()));
  scene.add(weld<M>(scene.bodies(), 1, 2, random.vector<M::linear>(1)));
  const double energy_at_first = kinetic_energy(scene.bodies());
  auto first = simulation;
  first.step(h);
  EXPECT_LT(kinetic_energy(first.scene.bodies()), energy_at_first);  // the joints were not yet kept by V
  const Lost coarse = lost_after_two_seconds(simulation, 1e-3), fine = lost_after_two_seconds(simulation, 5e-4);
  EXPECT_LT(coarse.linear, 2000 * 3 * 10 * 0x1p-53);  // 2,000 steps of three momenta of some 10 kg m/s
  if (M::linear == 2) {
    EXPECT_LT(coarse.angular, coarse.by_gaps + 1e-11);
  } else {
    EXPECT_LT(fine.angular, 0.55 * coarse.angular + coarse.by_gaps + fine.by_gaps);
  }
  EXPECT_NEAR(coarse.gap / fine.gap, 4, 0.05);
}

}  // namespace joints_hold_test
