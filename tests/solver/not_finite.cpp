#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <bit>
#include <limits>

#include "lessons/methods/method.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "tests/solver/random.hpp"

// NaN and infinity: a step that would leave one in the scene throws, and the scene stays as it was.
namespace not_finite_test {

using namespace byhand;

constexpr double h = 1.0 / 60;
constexpr double nan = std::numeric_limits<double>::quiet_NaN(),
                 infinity = std::numeric_limits<double>::infinity();

const Method methods[] = {AnyStepping{GaussSeidel{}},
                          AnyStepping{GaussSeidel{.tolerance = 1e-9}},
                          AnyStepping{Jacobi{.relaxation = 0.5}, Projection{}},
                          AnyStepping{Direct{.regularisation = 1e-9}},
                          AnyStepping{Direct{.factorisation = Factorisation::dense, .regularisation = 1e-9}},
                          AnyStepping{ConjugateSweeps{}, SplitImpulse{}},
                          AnyStepping{exact_sweeps()},
                          AnyStepping{ByGraph{}, SoftConstraints{}},
                          AnyStepping{ConjugateGradients{}},
                          AnyStepping{AcceleratedGradient{}},
                          AnyStepping{.substeps = 2, .gyroscopic = Gyroscopic::implicit},
                          Accelerations{Scheme::explicit_euler},
                          Accelerations{Scheme::rk4, 2},
                          Accelerations{Scheme::implicit_midpoint},
                          Rattle{2},
                          Controlled<Rattle>{},
                          Controlled<Generalised>{},
                          Xpbd{},
                          Xpbd{1},
                          Avbd{}};

/// All numbers of a scene's state, bit by bit, for NaN is not itself.
template <class M>
std::vector<std::uint64_t> bits(const Scene<M>& scene) {
  std::vector<std::uint64_t> result;
  const auto put = [&](const auto& vector) {
    for (const double x : vector) result.push_back(std::bit_cast<std::uint64_t>(x));
  };
  for (int i = 0; i < scene.bodies().size(); ++i) {
    const Pose<M>& pose = scene.bodies().pose[i];
    put(pose.position);
    put(scene.bodies().velocity[i]);
    if constexpr (M::angular == 1) put(Eigen::Vector2d(pose.rotation.cos, pose.rotation.sin));
    if constexpr (M::angular == 3) put(pose.rotation.coeffs());
  }
  return result;
}

template <class M>
bool is_finite(const Scene<M>& scene) {
  return are_finite(scene.bodies().pose, scene.bodies().velocity);
}

/// A chain and, where bodies have shapes and the method takes contacts, a stack of boxes.
template <class M, class F>
void for_each_case(F&& f) {
  for (const Method& any : methods)
    std::visit(
        [&](const auto& method) {
          std::vector<Scene<M>> scenes{rod_chain<M>({.links = 4, .angle = 1})};
          if constexpr (M::angular > 0) {
            scenes.push_back(pinned_chain<M>({.links = 4, .angle = 1}));
            scenes.push_back(stack<M>(3));
          }
          for (const Scene<M>& scene : scenes)
            if (refusal(scene, method).empty()) f(scene, method);
        },
        any);
}

TEST_IN_ALL_MODELS(NotFinite, IsThrownWhereABodyBeginsSo) {
  for_each_case<M>([](const Scene<M>& scene, const auto& method) {
    for (const double bad : {nan, infinity, -infinity})
      for (const int what : {0, 1, 2}) {
        if (what == 2 && M::angular == 0) continue;
        Simulation simulation{scene, method};
        simulation.step(h);
        Bodies<M>& bodies = simulation.scene.state();
        if (what == 0) bodies.pose[2].position[1] = bad;
        if (what == 1) bodies.velocity[2][0] = bad;
        if constexpr (M::angular == 1)
          if (what == 2) bodies.pose[2].rotation.sin = bad;
        if constexpr (M::angular == 3)
          if (what == 2) bodies.pose[2].rotation.x() = bad;
        const auto before = bits(simulation.scene);
        const double time = simulation.time;
        EXPECT_THAT([&] { simulation.step(h); },
                    testing::ThrowsMessage<NotFinite>(testing::ContainsRegex("body [0-9] has")));
        EXPECT_EQ(bits(simulation.scene), before);
        EXPECT_EQ(simulation.time, time);
      }
  });
}

/// The step throws and changes nothing, or it leaves finite numbers. Then, from a state that is sound, the
/// simulation goes on like a new one.
template <class M, class Method>
void expect_survived(Simulation<M, Method> simulation, double step, const Scene<M>& sound) {
  const auto before = bits(simulation.scene);
  bool thrown = false;
  try {
    simulation.step(step);
    EXPECT_TRUE(is_finite(simulation.scene));
  } catch (const std::runtime_error&) {  // also NoConvergence
    thrown = true;
    EXPECT_EQ(bits(simulation.scene), before);
    EXPECT_EQ(simulation.time, 0);
  }
  if (!thrown) return;
  simulation.scene = sound;
  Simulation<M, Method> fresh{sound, simulation.method};
  for (int i = 0; i < 3; ++i) {
    simulation.step(h);
    fresh.step(h);
  }
  EXPECT_EQ(bits(simulation.scene), bits(fresh.scene));
}

// Also where every body is infected by the end.
TEST(NotFinite, NamesTheBodyThatBeganIt) {
  for (const Method& any : {methods[0], methods[1], methods[3], methods[5], methods[12], methods[14], methods[15],
                            methods[16], methods[17]})
    std::visit(
        [](const auto& method) {
          Simulation simulation{pinned_chain<PlaneBody>({.links = 4, .angle = 1}), method};
          simulation.scene.state().velocity[3][0] = nan;
          EXPECT_THAT([&] { simulation.step(h); },
                      testing::ThrowsMessage<NotFinite>(testing::HasSubstr("body 3 has")));
        },
        any);
}

TEST_IN_ALL_MODELS(NotFinite, LeavesTheSceneAsItWasWhateverOverflows) {
  for_each_case<M>([](const Scene<M>& scene, const auto& method) {
    SCOPED_TRACE(typeid(method).name());
    for (const double huge : {1e100, 1e154, 1e200, 1e300}) {
      expect_survived(Simulation{scene, method}, huge, scene);
      Scene<M> heavy = scene;
      heavy.gravity *= huge;
      expect_survived(Simulation{heavy, method}, h, scene);
      Scene<M> fast = scene;
      for (int i = 1; i < fast.bodies().size(); ++i) fast.state().velocity[i][i % M::dof] = huge;
      expect_survived(Simulation{fast, method}, h, scene);
      Scene<M> far = scene;
      far.state().pose[2].position[0] = huge;
      expect_survived(Simulation{far, method}, h, scene);
    }
  });
}

TEST(NotFinite, NamesTheConstraintOrItsBodiesWhereItsRowsOverflow) {
  auto scene = rod_chain<PlaneParticle>({.links = 4, .angle = 1});
  scene.set_position(3, {1e200, 0});  // its square is infinite
  Simulation<PlaneParticle, AnyStepping> swept{scene, {GaussSeidel{}}}, direct{scene, {Direct{}}};
  EXPECT_THAT([&] { swept.step(h); },
              testing::ThrowsMessage<NotFinite>(testing::HasSubstr("constraint 2 has a value")));
  EXPECT_THAT([&] { direct.step(h); },
              testing::ThrowsMessage<NotFinite>(testing::ContainsRegex("between body [23] and body [34]")));
}

TEST_IN_ALL_MODELS(NotFinite, IsNotBlamedOnRowsThatRepeat) {
  for (const auto factorisation : {Factorisation::structured, Factorisation::dense}) {
    Simulation<M, AnyStepping> simulation{rod_chain<M>({.links = 4, .angle = 1}), {Direct{factorisation}}};
    simulation.scene.state().pose[3].position[0] = nan;
    EXPECT_THROW(simulation.step(h), NotFinite);
  }
}

TEST(Larger, IsNotANumberIfEitherIsNone) {
  EXPECT_EQ(larger(1, 2), 2);
  EXPECT_EQ(larger(2, 1), 2);
  EXPECT_TRUE(std::isnan(larger(nan, 1)));
  EXPECT_TRUE(std::isnan(larger(1, nan)));
}

TEST(Singular, AndNoConvergenceLeaveTheSceneAsItWas) {
  auto scene = rod_chain<PlaneParticle>({.links = 2, .angle = 1});
  Simulation<PlaneParticle, AnyStepping> simulation{scene, {Direct{}}};
  simulation.step(h);
  simulation.scene.add(Distance<PlaneParticle>{{0, 1}, 1});
  const auto before = bits(simulation.scene);
  EXPECT_THROW(simulation.step(h), SingularSystem);
  EXPECT_EQ(bits(simulation.scene), before);
  EXPECT_EQ(simulation.time, h);
}

TEST(Step, OfABallThatIsTooFastForItsContactToBeFoundLeavesNumbersOrThrows) {
  using M = SpaceBody;
  Scene<M> scene;
  const int ground = scene.add_body(Linear<M>(0, 0, 0), fixed<M>());
  scene.set_shape(ground, HalfSpace<M>{{0, 1, 0}});
  const Velocity<M> velocity = 1e160 * (Velocity<M>::Unit(0) - Velocity<M>::Unit(1));
  const int body = scene.add_body(Linear<M>(0, 0.1, 0), ball<M>(1, 0.1), velocity);
  scene.set_shape(body, Ball<M>{0.1});
  for (const AnyStepping& method : {AnyStepping{}, AnyStepping{ByGraph{}, Projection{}},
                                    AnyStepping{GaussSeidel{}, SoftConstraints{}}, AnyStepping{.substeps = 2}}) {
    Simulation simulation{scene, method};
    try {
      simulation.step(0.01);
    } catch (const NotFinite&) {
      EXPECT_EQ(simulation.scene.bodies().pose[body].position, scene.bodies().pose[body].position);
    }
    EXPECT_TRUE(are_finite(simulation.scene.bodies().pose, simulation.scene.bodies().velocity));
  }
}

}  // namespace not_finite_test
