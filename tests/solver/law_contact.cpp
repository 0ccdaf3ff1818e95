#include <gtest/gtest.h>

#include "lessons/scenes/balls.hpp"
#include "solver/constraints/contact_manifold.hpp"
#include "solver/contact/restitution.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Atlas A8, A9 and B2: what a contact carries, gives back and pushes out.
namespace law_contact_test {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60;

/// What the found face between body i - 1 and body i of a stack presses with [N].
double pressing(const Simulation<PlaneBody>& stack, int i) {
  return force(stack.work, i - 1) + force(stack.work, i - 1, 1);
}

void expect_weights(double top, const RowSolver& solver, double error) {
  Simulation<PlaneBody> simulation{stack(10, top), {solver}};
  run(simulation, 5, h);
  for (int i = 1; i <= 10; ++i) EXPECT_NEAR(pressing(simulation, i) / ((10 - i + top) * g), 1, error) << i;
}

TEST(LawA8, EachLayerOfAStackPressesWithTheWeightAboveIt) {
  expect_weights(1, GaussSeidel{300}, 1e-3);
  for (const double top : {1.0, 100.0}) {
    expect_weights(top, Direct{}, 1e-13);
    expect_weights(top, ByGraph{}, 1e-13);
  }
}

TEST(LawA9, FreeFallIsTheSumOfItsSteps) {
  Simulation<PlaneBody> simulation{bouncing_ball<PlaneBody>(10, 1), {}};
  for (int n = 1; n <= 60; ++n) {
    simulation.step(h);
    EXPECT_NEAR(simulation.scene.bodies().pose[1].position.y(), 10.5 - g * h * h * n * (n + 1) / 2, 1e-12);
  }
}

/// The heights of the first peaks after a fall from 1 m. The ground is seen from `margin` [m] above it.
template <class M>
std::vector<double> peaks(double restitution, int count, double step, double margin = 0.2) {
  Simulation<M> simulation{bouncing_ball<M>(1, restitution), {}};
  simulation.scene.set_margin(margin);
  std::vector<double> result;
  double before = 1, now = 1;
  while (static_cast<int>(result.size()) < count && simulation.time < 40) {
    simulation.step(step);
    const double next = simulation.scene.bodies().pose[1].position.y() - 0.5;
    if (now > before && now >= next) result.push_back(now);
    before = now;
    now = next;
    EXPECT_GE(now, margin < 0.1 ? -std::sqrt(2 * g) * step : -1e-12) << "it turns round on the ground";
  }
  return result;
}

TEST(LawA9, PeaksGoAsTheSquareOfTheRestitutionForEachBounce) {
  for (const double e : {1.0, 0.8, 0.5})
    for (const double step : {h, h / 4, h / 32}) {
      // Until what is left of the speed is below the threshold of 0.5 m/s.
      const int count = e == 1 ? 100 : static_cast<int>(std::log(0.5 / std::sqrt(2 * g)) / std::log(e));
      const auto measured = peaks<PlaneBody>(e, std::min(count, 10), step);
      ASSERT_EQ(static_cast<int>(measured.size()), std::min(count, 10));
      // Steps from rest pass through a parabola whose peak is gh²/8 above where they begin, and at each peak they
      // may miss as much.
      const double miss = g * step * step / 8;
      for (int n = 1; n <= static_cast<int>(measured.size()); ++n)
        EXPECT_NEAR(measured[n - 1], std::pow(e, 2 * n) * (1 + miss) - miss / 2, miss / 2 + 1e-9)
            << "e " << e << ", h " << step << ", bounce " << n;
    }
}

TEST(LawA9, ABounceNeverGainsHeight) {
  for (const double step : {1.0 / 30, h, h / 3})
    for (const double margin : {0.2, 0.02}) {  // as seen in time, and too late
      const auto measured = peaks<SpaceBody>(1, 20, step, margin);
      EXPECT_EQ(measured.size(), 20u);
      for (const double peak : measured) EXPECT_LE(peak, 1 + g * step * step / 8 + 1e-12) << step;
    }
}

TEST(LawA9, ASlowTouchDoesNotBounceAndALongFallEndsAtRest) {
  Simulation<PlaneBody> simulation{bouncing_ball<PlaneBody>(1, 0.8), {}};
  run(simulation, 10, h);
  EXPECT_NEAR(simulation.scene.bodies().velocity[1].norm(), 0, 1e-12);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.y(), 0.5, 1e-12);
}

// A slender body's inertia turns with it, noticeably from the start of a step to its end.
TEST(LawA9, ASlenderBarGainsNoEnergyByBouncing) {
  using M = SpaceBody;
  for (const double thickness : {0.02, 0.1, 0.7})
    for (const auto& [e, friction] : {std::pair{0.5, 0.0}, {0.5, 0.3}, {0.9, 0.0}, {0.9, 0.3}})
      for (int i = 0; i < 40; ++i) {
        const Surface surface{.friction = friction, .restitution = e};
        const Eigen::Vector3d half(0.5, thickness / 2, thickness / 2);
        const Pose<M> pose{{0, 0.6 + 0.01 * i, 0},
                           Eigen::Quaterniond(Eigen::AngleAxisd(0.3 + 0.13 * i, Eigen::Vector3d(0.8, 0, 0.6)))};
        const Velocity<M> V = (Velocity<M>() << 1, -3, 0, 5 * std::cos(3.0 * i), 0, 2).finished();
        Scene<M> scene;
        scene.set_shape(scene.add_body(Eigen::Vector3d(0, 0, 0), fixed<M>()), HalfSpace<M>{}, surface);
        scene.set_shape(scene.add_body(pose, box<M>(1, half), V), Box<M>{half}, surface);
        Simulation<M> simulation{std::move(scene), {}};
        const double first = energy_of_parabolas(simulation.scene, h);
        double most = first;
        run(simulation, 2, h, [&] { most = std::max(most, energy_of_parabolas(simulation.scene, h)); });
        EXPECT_LE(most, (1 + 1e-6) * first) << thickness << ' ' << e << ' ' << friction << ' ' << i;
      }
}

// A force that is proportional to mass is a weight.
TEST(LawA9, UnderAForceABarBouncesAsUnderItsWeight) {
  using M = SpaceBody;
  const Surface surface{.friction = 0.8, .restitution = 1};
  const Eigen::Vector3d sides(0.5, 0.05, 0.05);
  for (int i = 0; i < 40; ++i) {
    Scene<M> scene;
    scene.set_shape(scene.add_body(Eigen::Vector3d(0, 0, 0), fixed<M>()), HalfSpace<M>{}, surface);
    const Pose<M> pose{{0, 0.6, 0}, space_rotation(Eigen::Vector3d(0.24 + 0.1 * i, 0, 0.18))};
    scene.set_shape(scene.add_body(pose, box<M>(2, sides), {1, -3, 0, 2, 0, 2}), Box<M>{sides}, surface);
    Simulation<M> weighed{scene, {}}, pulled{scene, {}};
    pulled.scene.gravity.setZero();
    for (int step = 0; step < 30; ++step) {
      pulled.scene.add_force(1, 2 * weighed.scene.gravity);
      weighed.step(h), pulled.step(h);
      ASSERT_LT((weighed.scene.bodies().velocity[1] - pulled.scene.bodies().velocity[1]).norm(), 1e-7) << i;
    }
  }
}

TEST(LawA9, OnlyWhatMeetsFasterThanTheThresholdParts) {
  for (const double speed : {0.1, 0.5}) EXPECT_EQ(parting_rate(0.8, -speed, 0, 0, 0.5), 0);
  for (const double speed : {0.5000001, 3.0}) EXPECT_DOUBLE_EQ(parting_rate(0.8, -speed, 0, 0, 0.5), 0.8 * speed);
}

/// A ball in free fall that is thrown back by the article's row, b = e JV, once it overlaps: what the second solve
/// after the move is there to avoid.
std::vector<double> peaks_by_overlap(int count) {
  using M = PlaneParticle;
  const Contact<M> contact{{0, 1}};
  Pose<M> ground, ball;
  ball.position.y() = 1;
  const InverseMass<M> mass = with_mass<M>(1);
  const Jacobian<M, 1> J = contact.jacobian(ground, ball), W = times_inverse_mass(J, {}, ground, mass, ball);
  Velocity<M> still(0, 0), v(0, 0);
  std::vector<double> result;
  for (bool rising = false; static_cast<int>(result.size()) < count;) {
    v.y() -= g * h;
    const double approach = dot(J, still, v)[0];
    if (contact.value<double>(ground, ball)[0] < 0 && approach < 0)
      apply_impulse<M, 1>(W, Rows<1>(impulse(J, W, still, v, approach)), still, v);
    if (rising && v.y() < 0) result.push_back(ball.position.y());
    rising = v.y() > 0;
    move(ball, v, h);
  }
  return result;
}

TEST(LawA9, BouncingOnOverlapGainsAStepOfItsSpeedInHeight) {
  const auto measured = peaks_by_overlap(3);
  // It falls on for a step of gravity before it is thrown back: h times the speed of the impact more.
  EXPECT_NEAR(measured[0], 1 + 28 * g * h * h, 1e-12);
  const double atlas[] = {1.074, 1.155, 1.234};
  for (int n = 0; n < 3; ++n) EXPECT_NEAR(measured[n], atlas[n], 0.0035);
}

Scene<PlaneBody> pressed_in(double overlap) {
  Scene<PlaneBody> scene = stack(1);
  scene.state().pose[1].position.y() -= overlap;
  return scene;
}
/// How high over the ground a box gets that begins `overlap` deep in it.
double pop(double overlap, const Baumgarte& cure) {
  Simulation<PlaneBody> simulation{pressed_in(overlap), {Direct{}, cure}};
  double highest = -overlap;
  run(simulation, 3, h,
      [&] { highest = std::max(highest, simulation.scene.bodies().pose[1].position.y() - 0.5); });
  return highest;
}

TEST(LawB2, AnOverlapLeavesAtBetaTimesItsDepthPerStep) {
  for (const double beta : {0.05, 0.2, 0.8})
    for (const double overlap : {0.01, 0.3}) {
      Simulation<PlaneBody> simulation{pressed_in(overlap), {Direct{}, Baumgarte{beta}}};
      simulation.step(h);
      EXPECT_NEAR(simulation.scene.bodies().velocity[1].y(), beta * overlap / h, 1e-12);
    }
}

TEST(LawB2, ASpeedCapLowersTheJump) {
  const double free = pop(0.4, {.beta = 0.2});
  EXPECT_GT(free, 0.5);
  EXPECT_LE(pop(0.4, {.beta = 0.2, .speed_cap = 1}), 1e-9);
  Simulation<PlaneBody> simulation{pressed_in(0.4), {Direct{}, Baumgarte{.beta = 0.2, .speed_cap = 1}}};
  simulation.step(h);
  EXPECT_NEAR(simulation.scene.bodies().velocity[1].y(), 1, 1e-12);
}

TEST(LawB2, SlopIsLeftAlone) {
  Simulation<PlaneBody> simulation{pressed_in(0.01), {Direct{}, Baumgarte{.beta = 0.2, .slop = 0.002}}};
  run(simulation, 5, h);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.y() - 0.5, -0.002, 1e-9);
}

/// Six boxes and balls of .1 to 10 times a mass [kg] in a room of 8 m, thrown at 20 m/s; each has its own e, or
/// all the same.
template <class M>
Scene<M> room(double friction, double most_elastic, bool same, Random& random, double typical_mass = 1) {
  Scene<M> scene;
  scene.gravity.setZero();
  const auto surface = [&] {
    return Surface{.friction = friction, .restitution = same ? most_elastic : random.uniform(0, most_elastic)};
  };
  for (int axis = 0; axis < M::linear; ++axis)
    for (const double side : {-1.0, 1.0}) {
      const Linear<M> inwards = -side * Linear<M>::Unit(axis);
      scene.set_shape(scene.add_body(Linear<M>(-4 * inwards), fixed<M>()), HalfSpace<M>{inwards}, surface());
    }
  for (int i = 0; i < 6; ++i) {
    const Linear<M> at = -2 * Linear<M>::Ones() + 2 * (i % 3) * Linear<M>::Unit(0) +
                         2 * (i / 3) * Linear<M>::Unit(1),
                    sides = Linear<M>::Constant(0.3) + random.vector<M::linear>(0.2).cwiseAbs();
    const double mass = typical_mass * std::pow(10, random.uniform(-1, 1));
    const Velocity<M> V = random.vector<M::dof>(20);
    if (i % 2 == 0)
      scene.set_shape(scene.add_body(at, box<M>(mass, sides), V), Box<M>{sides}, surface());
    else
      scene.set_shape(scene.add_body(at, ball<M>(mass, 0.3), V), Ball<M>{0.3}, surface());
  }
  return scene;
}

// With friction, or unlike e, a solve of Moreau's law made up to 2.6 times the energy.
TEST(LawA9, ABounceMakesNoEnergyWhateverRubsAndHoweverUnlikeTheSurfaces) {
  const auto largest_gain = []<class M>(std::type_identity<M>, double friction, double e, bool same, int rooms,
                                        double typical_mass = 1) {
    Random random;
    double largest = 0;
    for (int i = 0; i < rooms; ++i) {
      Simulation<M> simulation{room<M>(friction, e, same, random, typical_mass)};
      for (int step = 0; step < 200; ++step) {
        const double before = energy(simulation.scene);
        simulation.step(h);
        largest = std::max(largest, energy(simulation.scene) / before - 1);
      }
    }
    return largest;
  };
  for (const bool same : {true, false})
    for (const double friction : {0.0, 0.6})
      for (const double e : {0.7, 1.0}) {
        EXPECT_LE(largest_gain(std::type_identity<PlaneBody>(), friction, e, same, 60), 0.05)
            << friction << e << same;
        EXPECT_LE(largest_gain(std::type_identity<SpaceBody>(), friction, e, same, 20), 0.05)
            << friction << e << same;
      }
  EXPECT_LE(largest_gain(std::type_identity<PlaneBody>(), 0.6, 1, false, 60, 1e-5), 0.05) << "of a few grains";
}

}  // namespace law_contact_test
