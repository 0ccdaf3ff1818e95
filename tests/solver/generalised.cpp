#include "lessons/methods/generalised.hpp"

#include <Eigen/Dense>

#include "lessons/exact/swinging_chain.hpp"
#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/four_bar.hpp"
#include "solver/constraints/hinge.hpp"
#include "solver/constraints/normalised_distance.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/equalities.hpp"
#include "tests/solver/random.hpp"
#include "tests/solver/swing.hpp"

namespace generalised_test {

using namespace byhand;
using testing::HasSubstr;
constexpr double pi = std::numbers::pi, g = 9.81, h = 1.0 / 60;
const Generalised euler{JointRule::semi_implicit_euler}, rk4{};

/// One point of a body stays as high as one of another: a joint that nobody has heard of.
template <class M>
struct SameHeight {
  static constexpr int rows = 1;
  Anchors<M> at;

  template <class T>
  Rows<1, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    return Rows<1, T>(at.separation(pose1, pose2).y());
  }
  Jacobian<M, 1> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    Jacobian<M, 1> J;
    J.matrix = Pin<M>{at}.jacobian(pose1, pose2).matrix.row(1);
    return J;
  }
};

/// The farthest that the centre of any body is from its place in another scene [m].
template <class M>
double apart(const Scene<M>& one, const Scene<M>& other) {
  double farthest = 0;
  for (int i = 0; i < one.bodies().size(); ++i)
    farthest = std::max(farthest, (one.bodies().pose[i].position - other.bodies().pose[i].position).norm());
  return farthest;
}
template <class M, class Method>
Scene<M> after(const Scene<M>& scene, const Method& method, double time, double step) {
  Simulation simulation{scene, method};
  run(simulation, time, step);
  return simulation.scene;
}

/// A random tree of bodies, each joined to an earlier one by a random kind of joint, at velocities that all joints
/// allow: RATTLE's projection of random ones. Body 0 is fixed or, where it `floats`, as free as the others.
template <class M>
Scene<M> random_tree(Random& random, int bodies, bool floats) {
  Scene<M> scene;
  scene.add_body(random.pose<M>(), floats ? random.mass<M>() : fixed<M>());
  for (int body = 1; body < bodies; ++body) {
    const int parent = random.index(body);
    const Linear<M> point = scene.bodies().pose[parent].position + random.vector<M::linear>(0.7);
    Pose<M> pose = random.pose<M>();
    pose.position = point + random.vector<M::linear>(0.7);
    scene.add_body(pose, random.mass<M>());
    const auto [one, two] = random.index(2) ? std::pair(parent, body) : std::pair(body, parent);
    const int kind = M::angular == 0 ? 4 : random.index(5);
    if constexpr (M::angular > 0) {
      const Linear<M> axis = random.vector<M::linear>(1);
      if (kind == 0) scene.add(pin<M>(scene.bodies(), one, two, point));
      if (kind == 1) scene.add(slider<M>(scene.bodies(), one, two, point, axis));
      if (kind == 2) scene.add(weld<M>(scene.bodies(), one, two, point));
      if constexpr (M::angular == 3)
        if (kind == 3) scene.add(hinge<M>(scene.bodies(), one, two, point, axis));
    }
    if (kind == 4 || (kind == 3 && M::angular == 1)) {
      const Linear<M> far = point + random.vector<M::linear>(0.5);
      NormalisedDistance<M> rod{
          between<M>(scene.bodies(), one, one == body ? point : far, two, two == body ? point : far)};
      rod.length = rod.at.separation(scene.bodies().pose[one], scene.bodies().pose[two]).norm();
      scene.add(rod);
    }
  }
  for (int body = floats ? 0 : 1; body < bodies; ++body) scene.state().velocity[body] = random.velocity<M>();
  return after(scene, Rattle{}, 1e-9, 1e-9);
}

// The dense equations of motion in angles from straight down, by Lagrange: with l_ik the way that link i turns the
// centre of link k, and m_ij = Σ_k m_k l_ik l_jk,
//   Σ_j (m_ij cos(θ_i - θ_j) + δ_ij I_i) θ̈_j = -Σ_j m_ij sin(θ_i - θ_j) θ̇_j² - g sin θ_i Σ_k m_k l_ik.
TEST(Generalised, AcceleratesAChainAsItsDenseLagrangianDoes) {
  using M = PlaneBody;
  Random random;
  for (int draw = 0; draw < 50; ++draw) {
    const int links = 1 + random.index(8);
    Eigen::VectorXd angle(links), rate(links), length(links), mass(links), inertia(links);
    Scene<M> scene;
    scene.add_body(Linear<M>(0, 0), fixed<M>());
    Linear<M> end(0, 0), velocity(0, 0);
    for (int i = 0; i < links; ++i) {
      angle[i] = random.uniform(-3, 3), rate[i] = random.uniform(-5, 5);
      length[i] = random.uniform(0.1, 3), mass[i] = std::pow(10, random.uniform(-2, 2));
      inertia[i] = mass[i] * length[i] * length[i] * random.uniform(0.02, 0.3);
      const Linear<M> along = from_straight_down<M>(angle[i]), aside(-along.y(), along.x());
      Velocity<M> V;
      V << velocity + rate[i] * length[i] / 2 * aside, rate[i];
      scene.add_body(Pose<M>{end + length[i] / 2 * along, plane_rotation(angle[i])},
                     with_mass<M>(mass[i], Angular<M>(inertia[i])), V);
      scene.add(pin<M>(scene.bodies(), i, i + 1, end));
      end += length[i] * along, velocity += length[i] * rate[i] * aside;
    }
    const auto reach = [&](int i, int k) { return i < k ? length[i] : i == k ? length[i] / 2 : 0.0; };
    Eigen::MatrixXd A = inertia.asDiagonal();
    Eigen::VectorXd b = Eigen::VectorXd::Zero(links);
    for (int i = 0; i < links; ++i)
      for (int k = i; k < links; ++k) {
        b[i] -= g * std::sin(angle[i]) * mass[k] * reach(i, k);
        for (int j = 0; j <= k; ++j) {
          const double m = mass[k] * reach(i, k) * reach(j, k);
          A(i, j) += m * std::cos(angle[i] - angle[j]);
          b[i] -= m * std::sin(angle[i] - angle[j]) * rate[j] * rate[j];
        }
      }
    const Eigen::VectorXd exact = A.ldlt().solve(b);
    Simulation simulation{scene, euler};
    const double step = 1e-3;
    simulation.step(step);
    for (int i = 0; i < links; ++i)
      EXPECT_NEAR((simulation.scene.bodies().velocity[i + 1][2] - rate[i]) / step, exact[i],
                  1e-9 * (1 + exact.cwiseAbs().maxCoeff()))
          << "link " << i << " of " << links << ", draw " << draw;
  }
}

// Accelerations solve for the forces of all joints and know nothing of trees.
TEST_IN_ALL_MODELS(Generalised, MovesAnyTreeAsTheForcesOfItsConstraintsDo, 25) {
  for (const bool floats : {false, true}) {
    const Scene<M> scene = random_tree<M>(random, 2 + random.index(8), floats);
    ASSERT_EQ(refusal(scene, rk4), "");
    const double span = 0.125, scale = 10;
    const Scene<M> by_forces = after(scene, Accelerations{}, span, span / 4096),
                   by_joints = after(scene, rk4, span, span / 1024);
    EXPECT_LT(apart(by_joints, by_forces), 1e-8 * scale)
        << scene.count() << " joints" << (floats ? ", floating" : "");
    EXPECT_LT(position_error(by_joints).max, 1e-13);
  }
}

// RATTLE's runs converge towards it with the square of their step.
TEST(Generalised, IsWhatRattleConvergesTo) {
  const auto converges = [](const auto& scene) {
    const auto exact = after(scene, rk4, 1, 1.0 / 4096);
    const double coarse = apart(after(scene, Rattle{}, 1, 1.0 / 512), exact),
                 fine = apart(after(scene, Rattle{}, 1, 1.0 / 1024), exact);
    EXPECT_NEAR(order(coarse, fine), 2, 0.1) << coarse << ", " << fine;
  };
  converges(pinned_chain<PlaneBody>({.links = 10, .end_mass = 100, .angle = pi / 2}));
  converges(pinned_chain<SpaceBody>({.links = 4, .angle = 1.2}));
  converges(rod_chain<SpaceBody>({.links = 3, .angle = 1.2}));
  converges(pinned_tree<PlaneBody>(4));
  converges(leaning_top());
}

// So it is exact to its rule's error at any length: against two unrelated integrations in the links' angles.
TEST(Generalised, SwingsAChainAsItsReferenceDoes) {
  const int links = 10;
  const std::vector<SwingingChain::Link> all(links, {1, 0.5, 1, 1.01 / 12});
  const SwingingChain::State exact = SwingingChain(all, pi / 2, g).at(1);
  const auto scene = after(pinned_chain<PlaneBody>({.links = links, .angle = pi / 2}), rk4, 1, 1.0 / 1920);
  for (int i = 0; i < links; ++i)
    EXPECT_LT((scene.bodies().pose[i + 1].position - exact.positions[i]).norm(), 1e-8 + 10 * exact.uncertainty);
}

// What MuJoCo, DART and PhysX's articulations err by with four steps a frame: the same rule in the same angles.
TEST(Generalised, BySemiImplicitEulerErrsAsEnginesInJointAnglesDo) {
  const auto farthest = [](int links, double end_mass) {
    std::vector<SwingingChain::Link> all(links, {1, 0.5, 1, 1.0 / 12});
    all.back().mass = end_mass, all.back().inertia = end_mass / 12;
    const SwingingChain exact(all, pi / 2, g);
    Scene<PlaneBody> scene = pinned_chain<PlaneBody>({.links = links, .end_mass = end_mass, .angle = pi / 2});
    for (int i = 1; i <= links; ++i)
      scene.set_mass(i, with_mass<PlaneBody>(all[i - 1].mass, Angular<PlaneBody>(all[i - 1].inertia)));
    Simulation simulation{scene, euler};
    double most = 0;
    for (int frame = 1; frame <= 120; ++frame) {
      for (int i = 0; i < 4; ++i) simulation.step(h / 4);
      const SwingingChain::State state = exact.at(frame * h, 1e-9);
      for (int i = 0; i < links; ++i)
        most = std::max(most, (simulation.scene.bodies().pose[i + 1].position - state.positions[i]).norm());
    }
    return most;
  };
  EXPECT_NEAR(farthest(10, 1), 0.301, 0.0015);
  EXPECT_NEAR(farthest(10, 100), 0.0541, 0.0003);
}

TEST(Generalised, SwingsAPendulumByItsRulesOrderAndStretchesNothing) {
  const SwingErrors fourth = swing<Distance>(rk4, h), first = swing<Distance>(euler, h);
  EXPECT_LT(std::abs(fourth.period_error), 1e-6);
  EXPECT_LT(std::abs(fourth.angle_error), 1e-6);
  EXPECT_LT(fourth.stretch, 1e-15);
  EXPECT_LT(first.stretch, 1e-15);
  EXPECT_LT(std::abs(first.period_error), 1e-3) << "conjugate to leapfrog";
  EXPECT_NEAR(order(first.angle_error, swing<Distance>(euler, h / 2).angle_error), 1, 0.1);
}

// A rod hangs from a crank that turns at ω: (I + ml²)θ̈ = -ml ((g + p̈_y) sin θ + p̈_x cos θ), where p̈ = -ω²p is the
// pivot's. Each stage of a rule finds the crank where it is at the stage's time, or the order is lost.
TEST(Generalised, FollowsADrivenCrankToItsRulesOrder) {
  using M = PlaneBody;
  const double omega = 3, arm = 0.5, mass = 2, half = 0.4, inertia = 0.3, time = 1;
  const auto rate = [&](double t, const Eigen::Vector2d& at) {
    const double turned = omega * t, x = -omega * omega * arm * std::cos(turned),
                 y = -omega * omega * arm * std::sin(turned);
    return Eigen::Vector2d(
        at[1], -mass * half * ((g + y) * std::sin(at[0]) + x * std::cos(at[0])) / (inertia + mass * half * half));
  };
  Eigen::Vector2d exact(0, 0);
  constexpr int parts = 4000;
  for (int i = 0; i < parts; ++i) {
    const double t = time * i / parts, s = time / parts;
    const Eigen::Vector2d a = rate(t, exact), b = rate(t + s / 2, exact + s / 2 * a),
                          c = rate(t + s / 2, exact + s / 2 * b), d = rate(t + s, exact + s * c);
    exact += s / 6 * (a + 2 * b + 2 * c + d);
  }
  const auto error = [&](double step) {
    Scene<M> scene;
    scene.add_body(Linear<M>(0, 0), fixed<M>(), {0, 0, omega});
    scene.add_body(Linear<M>(arm, -half), with_mass<M>(mass, Angular<M>(inertia)), {0, omega * arm, 0});
    scene.add(Pin<M>{between<M>(scene.bodies(), 0, {arm, 0}, 1, {arm, 0})});
    const Scene<M> end = after(scene, rk4, time, step);
    const auto& rotation = end.bodies().pose[1].rotation;
    return std::atan2(rotation.sin, rotation.cos) - exact[0];
  };
  EXPECT_LT(std::abs(error(1.0 / 64)), 1e-5);
  EXPECT_GT(order(error(1.0 / 32), error(1.0 / 64)), 3.5);
}

TEST(Generalised, SemiImplicitEulerInOneAngleKeepsItsEnergyBounded) {
  const auto worst = [](double time) {
    Simulation simulation{pendulum<PlaneParticle>(2, 1, 1), euler};
    const double start = energy(simulation.scene);
    double most = 0;
    run(simulation, time, h, [&] { most = std::max(most, std::abs(energy(simulation.scene) - start)); });
    return most;
  };
  EXPECT_LT(worst(1000), 1.1 * worst(10));
}

TEST_IN_ALL_MODELS(Generalised, KeepsEnergyAndMomentumOfAFloatingTree, 5) {
  Scene<M> scene = random_tree<M>(random, 6, true);
  scene.gravity.setZero();
  // As shares; nothing keeps them but the order of the rule.
  const auto changes = [&](double step) {
    const Scene<M> end = after(scene, rk4, 0.5, step);
    const auto momentum = linear_momentum(scene.bodies());
    const auto turning = angular_momentum(scene.bodies());
    return Eigen::Vector3d(std::abs(energy(end) / energy(scene) - 1),
                           (linear_momentum(end.bodies()) - momentum).norm() / (1 + momentum.norm()),
                           (angular_momentum(end.bodies()) - turning).norm() / (1 + turning.norm()));
  };
  const Eigen::Vector3d coarse = changes(1.0 / 2048), fine = changes(1.0 / 4096);
  for (int i = 0; i < 3; ++i) {
    EXPECT_LT(fine[i], 1e-6);
    EXPECT_LT(fine[i], coarse[i] / 8 + 1e-11);
  }
}

TEST(Generalised, NeverOpensAJointWhateverTheStep) {
  auto scene = pinned_chain<SpaceBody>({.links = 10, .end_mass = 1000, .angle = pi / 2});
  for (const double step : {1.0 / 60, 1.0 / 600}) {
    Simulation simulation{scene, rk4};
    double most = 0;
    run(simulation, 0.5, step, [&] { most = std::max(most, position_error(simulation.scene).max); });
    EXPECT_LT(most, 1e-14 * 10);
  }
}

TEST_IN_ALL_MODELS(Generalised, ClosesAGapAtTheStart, 5) {
  Scene<M> scene = random_tree<M>(random, 5, false);
  scene.state().pose[3].position += random.vector<M::linear>(0.01);
  Simulation simulation{scene, rk4};
  simulation.step(1e-3);
  EXPECT_LT(position_error(simulation.scene).max, 1e-13);
}

// The work of a step is proportional to the number of joints.
TEST(Generalised, CostsTheSameForEachJoint) {
  const auto cost = [](int links) {
    Simulation simulation{pinned_chain<PlaneBody>({.links = links, .angle = 1}), rk4};
    simulation.step(1e-3);
    return simulation.work.row_solves;
  };
  EXPECT_EQ(cost(1), 4);
  EXPECT_EQ(cost(1000), 4000);
}

TEST(Generalised, DoesTheSameAtAnyLength) { expect_same_at_any_length_of_rods_and_pins(rk4); }

TEST(Generalised, RefusesWhatItCannotRun) {
  expect_refusals(rk4);
  expect_invalid(Generalised{.substeps = 0}, "number of substeps is 0");
  expect_thrown<std::invalid_argument>(four_bar({}), rk4, 0.01, "close a loop");
  Scene<PlaneBody> scene = pinned_chain<PlaneBody>({.links = 2});
  scene.add(SameHeight<PlaneBody>{{1, 2}});
  EXPECT_THAT(refusal(scene, rk4), HasSubstr("constraint 2 is none of them"));
  scene = pinned_chain<PlaneBody>({.links = 2});
  scene.set_shape(2, Box<PlaneBody>{{0.1, 1}});
  EXPECT_THAT(refusal(scene, rk4), HasSubstr("knows no contacts"));
}

// A constraint that comes between two steps changes the tree; one that closes a loop is refused, and nothing
// moves.
TEST(Generalised, NoticesThatTheSceneHasChanged) {
  Simulation simulation{pinned_chain<PlaneBody>({.links = 3, .angle = 1}), rk4};
  simulation.step(h);
  simulation.scene.remove(1);
  simulation.step(h);
  EXPECT_LT(position_error(simulation.scene).max, 1e-15);
  auto& scene = simulation.scene;
  scene.add(pin<PlaneBody>(scene.bodies(), 0, 1, {0.3, 0.3}));
  EXPECT_THROW(simulation.step(h), std::invalid_argument);
}

// Along a rod nothing can move, so that a velocity along it is none of the joint's.
TEST(Generalised, LeavesOutAVelocityAlongARod) {
  using M = SpaceParticle;
  Scene<M> scene;
  scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  scene.add_body(Linear<M>(0.6, 0.8, 0), with_mass<M>(2), {0.4, -0.3, 0.7});
  scene.add(NormalisedDistance<M>{{0, 1}, 1});
  Scene<M> pulled = scene;
  pulled.state().velocity[1] += 3 * Velocity<M>(0.6, 0.8, 0);
  EXPECT_LT(apart(after(scene, rk4, 0.5, h), after(pulled, rk4, 0.5, h)), 1e-12);
}

}  // namespace generalised_test
