#include <gtest/gtest.h>

#include "lessons/methods/method.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/anchors.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/dual.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// A kind of constraint that the library does not know: a program defines it as a plain struct and adds it to a
// scene.
namespace own_kind_test {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60;

/// Keeps a point of body 2 on a line, in space on a plane, that body 1 carries through a point of its own.
///
///   C = n · (P2 - P1),  n turns with body 1                                                      [m]
///   Ċ = n · (v2 + ω2 × r2 - v1 - ω1 × r1) + (ω1 × n) · (P2 - P1)
///   J = [ -n   -(P2 - x1) × n   n   r2 × n ],  for r1 + P2 - P1 = P2 - x1
template <class M>
struct OnLine {
  static constexpr int rows = 1;

  Anchors<M> at;
  Linear<M> normal = Linear<M>::Unit(1);  // n, in the frame of body 1

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    Linear<M, T> n = normal.template cast<T>();
    if constexpr (M::angular > 0) n = rotate(pose1.rotation, Linear<M, T>(n));
    return Rows<1, T>(n.dot(at.separation(pose1, pose2)));
  }
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J;
    if constexpr (M::angular == 0) {
      J.set_row(0, Linear<M>(-normal), Angular<M>(), normal, Angular<M>());
    } else {
      const Linear<M> n = rotate(pose1.rotation, normal), r2 = in_world<M, double>(pose2, at.arms.second);
      const Linear<M> to_point = pose2.position + r2 - pose1.position;
      J.set_row(0, Linear<M>(-n), Angular<M>(-cross(to_point, n)), n, Angular<M>(cross(r2, n)));
    }
    return J;
  }
  void require_valid(const Bodies<M>&) const {
    require_in("length of the normal", normal.norm(), 1 - 1e-9, 1 + 1e-9);
  }
};

TEST_IN_ALL_MODELS(OwnKind, HasTheGradientOfItsValue, 100) {
  const auto pair = random_pair<M>(random);
  const OnLine<M> line{pair.at, random.direction<M>()};
  EXPECT_LE(
      difference(line.jacobian(pair.pose1, pair.pose2).matrix, gradient_by_duals(line, pair.pose1, pair.pose2)),
      1e-13);
}

/// A body of 2 kg on a line that falls off to the right by `slope` [rad].
template <class M>
Scene<M> on_a_slope(double slope) {
  const auto [sin, cos] = sin_cos(slope);
  Scene<M> scene;
  Pose<M> ground;
  OnLine<M> line{{0, 1}};
  if constexpr (M::angular == 0) line.normal = sin * Linear<M>::Unit(0) + cos * Linear<M>::Unit(1);
  if constexpr (M::angular == 1) ground.rotation = plane_rotation(-slope);
  if constexpr (M::angular == 3) ground.rotation = space_rotation(Angular<M>(0, 0, -slope));
  scene.add_body(ground, fixed<M>());
  InverseMass<M> mass;
  if constexpr (M::angular == 0)
    mass = with_mass<M>(2);
  else
    mass = box<M>(2, Linear<M>::Constant(0.3));
  scene.add_body(Linear<M>(Linear<M>::Zero()), mass);
  scene.add(line);
  return scene;
}

// It slides with g sin φ and presses with m g cos φ: half a step ahead where velocities come first.
template <class M>
void expect_slid(double slope, double ahead, const Linear<M>& position, const Linear<M>& force, double tolerance) {
  const Linear<M> along = std::cos(slope) * Linear<M>::Unit(0) - std::sin(slope) * Linear<M>::Unit(1);
  const Linear<M> out = std::sin(slope) * Linear<M>::Unit(0) + std::cos(slope) * Linear<M>::Unit(1);
  const Linear<M> expected = 0.5 * g * std::sin(slope) * (1 + ahead) * along;
  EXPECT_LT((position - expected).norm(), tolerance);
  EXPECT_LT((force - 2 * g * std::cos(slope) * out).norm(), tolerance);
}

template <class Method>
void expect_slide(const Method& method, double ahead, double tolerance) {
  in_all_models([&]<class M>(Random&) {
    for (const double slope : {0.2, 1.0}) {
      Simulation simulation{on_a_slope<M>(slope), method};
      run(simulation, 1, h);
      expect_slid<M>(slope, ahead, simulation.scene.bodies().pose[1].position,
                     simulation.reaction(simulation.scene.entries()[0].id).force, tolerance);
    }
  });
}

TEST(OwnKind, SlidesDownASlopeByEveryMethod) {
  expect_slide(VelocityStepping{}, h, 1e-11);
  expect_slide(VelocityStepping{Direct{}}, h, 1e-11);
  expect_slide(VelocityStepping{GaussSeidel{}, SplitImpulse{}}, h, 1e-11);
  expect_slide(Xpbd{1, 1}, h, 1e-9);  // what C keeps of rounding, over h²
  expect_slide(Rattle{}, 0, 1e-10);
  expect_slide(Accelerations{}, 0, 1e-10);
}

TEST(OwnKind, KeepsItsOrderAndItsHandleAmongThoseOfTheLibrary) {
  using M = PlaneBody;
  Scene<M> scene = pinned_chain<M>({.links = 2, .angle = 1});
  const auto line = scene.add(OnLine<M>{{0, 2}, Linear<M>(1, 0)});
  const auto rod = scene.add(Distance<M>{{0, 1}, 0.5});
  EXPECT_EQ(scene.place(line), 2);
  scene.remove(scene.entries()[0].id);
  EXPECT_EQ(scene.place(line), 1);
  EXPECT_EQ(scene.get(line).normal, Linear<M>(1, 0));
  scene.change(line, [](auto& it) { it.normal = Linear<M>(0, 1); });
  EXPECT_EQ(scene.all<OnLine>()[0].normal, Linear<M>(0, 1));
  EXPECT_THROW(scene.change(line, [](auto& it) { it.normal *= 2; }), std::invalid_argument);
  EXPECT_THROW(scene.add(OnLine<M>{{0, 9}}), std::invalid_argument);
  const Scene<M> copy = scene;
  scene.remove(line);
  EXPECT_TRUE(scene.all<OnLine>().empty());
  EXPECT_EQ(copy.all<OnLine>().size(), 1u);
  EXPECT_EQ(scene.place(rod), 1);
}

// The carrier turns too: momentum of the two together stays.
TEST_IN_ALL_MODELS(OwnKind, KeepsTheMomentumOfTwoThatFloat) {
  auto pair = random_pair<M>(random);
  Scene<M> scene = pair.scene();
  scene.gravity.setZero();
  scene.add(OnLine<M>{pair.at, random.direction<M>()});
  const auto linear = linear_momentum(scene.bodies());
  const auto angular = angular_momentum(scene.bodies());
  Work<M> work;
  const auto poses = scene.bodies().pose;
  advance(scene, {.solver = GaussSeidel{3}, .drift = NoDriftCure{}, .gyroscopic = Gyroscopic::none}, h, work);
  EXPECT_GT(std::abs(work.system.lambda[0]), 1e-3);
  scene.state().pose = poses;  // where the row was written
  EXPECT_LE(difference(linear_momentum(scene.bodies()), linear), 1e-12);
  if constexpr (M::angular > 0) {
    EXPECT_LE(difference(angular_momentum(scene.bodies()), angular), 1e-12);
  }
}

}  // namespace own_kind_test
