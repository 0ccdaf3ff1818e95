#include <gtest/gtest.h>

#include "lessons/methods/accelerations.hpp"
#include "lessons/methods/avbd.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/methods/row_solvers.hpp"
#include "lessons/methods/xpbd.hpp"
#include "lessons/scenes/box_pile.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/top.hpp"
#include "solver/constraints/spring.hpp"
#include "solver/constraints/weld.hpp"

// No absolute length, mass or time hides in a method: the same scene in other units moves the same way. Units are
// powers of four here, and so are the same to the last bit: products of powers of two are exact, and so are the
// square roots of masses that some solvers take.
namespace units_test {

using namespace byhand;

/// The numbers of a metre, a kilogram and a second in other units.
struct Units {
  double length = 1, mass = 1, time = 1;

  double speed() const { return length / time; }
  double stiffness() const { return mass / (time * time); }
};

const Units all_units[] = {{0x1p10, 1, 1}, {0x1p-10, 1, 1}, {1, 0x1p10, 1},          {1, 0x1p-10, 1},
                           {1, 1, 0x1p10}, {1, 1, 0x1p-2},  {0x1p20, 0x1p-10, 0x1p4}};

template <class M, template <class> class Kind, class F>
void change_all(Scene<M>& scene, const Units& units, F&& change) {
  scene.template change_all<Kind>([&](Kind<M>& constraint) {
    if constexpr (M::angular > 0) {
      constraint.at.arms.first *= units.length;
      constraint.at.arms.second *= units.length;
    }
    change(constraint);
  });
}

template <class M>
Scene<M> in_units(Scene<M> scene, const Units& units) {
  scene.gravity *= units.speed() / units.time;
  scene.set_margin(scene.colliders().margin * units.length);
  for (int i = 0; i < scene.bodies().size(); ++i) {
    const Bodies<M>& bodies = scene.bodies();
    Pose<M> pose = bodies.pose[i];
    pose.position *= units.length;
    Velocity<M> velocity = bodies.velocity[i] / units.time;
    velocity.template head<M::linear>() *= units.length;
    InverseMass<M> mass = bodies.inverse_mass[i];
    mass.linear /= units.mass;
    if constexpr (M::angular > 0) mass.angular /= units.mass * units.length * units.length;
    scene.set_pose(i, pose);
    scene.set_mass(i, mass);
    scene.set_velocity(i, velocity);
    if constexpr (M::angular > 0)
      if (i < std::ssize(scene.colliders().shapes)) {
        Shape<M> shape = scene.colliders().shapes[i];
        if (auto* ball = std::get_if<Ball<M>>(&shape)) ball->radius *= units.length;
        if (auto* box = std::get_if<Box<M>>(&shape)) box->sides *= units.length;
        scene.set_shape(i, shape, scene.colliders().surfaces[i]);
      }
  }
  change_all<M, Distance>(scene, units, [&](auto& rod) { rod.length *= units.length; });
  change_all<M, NormalisedDistance>(scene, units, [&](auto& rod) { rod.length *= units.length; });
  change_all<M, Spring>(scene, units, [&](auto& spring) {
    spring.length *= units.length;
    spring.elastic.stiffness *= units.stiffness();
    spring.elastic.damping *= units.stiffness() * units.time;
  });
  change_all<M, Pin>(scene, units, [](auto&) {});
  if constexpr (M::angular > 0) change_all<M, Weld>(scene, units, [](auto&) {});
  return scene;
}

/// Expects `steps` of a scene to be the same in all units. method(units) gives the method with its own quantities
/// in these.
template <class M, class F>
void expect_same_in_all_units(const char* name, const Scene<M>& scene, F&& method, int steps = 30) {
  const double h = 1.0 / 64;
  Simulation plain{scene, method(Units{})};
  for (int i = 0; i < steps; ++i) plain.step(h);
  for (const Units& units : all_units) {
    Simulation other{in_units(scene, units), method(units)};
    for (int i = 0; i < steps; ++i) other.step(h * units.time);
    const Bodies<M>&expected = plain.scene.bodies(), &found = other.scene.bodies();
    for (int i = 0; i < expected.size(); ++i) {
      const auto where = [&] {
        return testing::Message() << name << ", body " << i << ", units " << units.length << " " << units.mass
                                  << " " << units.time;
      };
      ASSERT_EQ(found.pose[i].position, units.length * expected.pose[i].position) << where();
      ASSERT_EQ(found.velocity[i].template head<M::linear>(),
                units.speed() * expected.velocity[i].template head<M::linear>())
          << where();
      if constexpr (M::angular > 0) {
        ASSERT_EQ(found.velocity[i].template tail<M::angular>(),
                  1 / units.time * expected.velocity[i].template tail<M::angular>())
            << where();
      }
    }
  }
}

template <class M>
void expect_velocity_stepping_same(const char* scene_name, const Scene<M>& scene) {
  const auto expect_same = [&](const char* name, const AnyRowSolver& solver, auto&& cure) {
    expect_same_in_all_units((std::string(scene_name) + ", " + name).c_str(), scene, [&](const Units& units) {
      return AnyStepping{
          .solver = solver, .drift = cure(units), .substeps = 2, .bounce_threshold = 0.5 * units.speed()};
    });
  };
  const auto baumgarte = [](const Units& units) -> DriftCure {
    return Baumgarte{.slop = 0.001 * units.length, .speed_cap = 3 * units.speed()};
  };
  expect_same("by graph", ByGraph{}, baumgarte);
  expect_same("Gauss-Seidel", GaussSeidel{}, baumgarte);
  expect_same("Gauss-Seidel, coloured", GaussSeidel{.order = SweepOrder::coloured}, baumgarte);
  expect_same("Jacobi", Jacobi{}, baumgarte);
  expect_same("conjugate sweeps", ConjugateSweeps{}, baumgarte);
  expect_same("accelerated gradient", AcceleratedGradient{}, baumgarte);
  expect_same("no cure", GaussSeidel{}, [](const Units&) -> DriftCure { return NoDriftCure{}; });
  expect_same("split impulse", GaussSeidel{}, [](const Units&) -> DriftCure { return SplitImpulse{}; });
  expect_same("projection", GaussSeidel{},
              [](const Units& units) -> DriftCure { return Projection{.slop = 0.001 * units.length}; });
  expect_same("soft constraints", GaussSeidel{},
              [](const Units& units) -> DriftCure { return SoftConstraints{.frequency = 90 / units.time}; });
}

template <class M>
void expect_positions_same(const char* name, const Scene<M>& scene) {
  expect_same_in_all_units((std::string(name) + ", XPBD").c_str(), scene, [](const Units& units) {
    return Xpbd{.push_speed = units.speed(), .bounce_threshold = 0.5 * units.speed()};
  });
  expect_same_in_all_units((std::string(name) + ", AVBD").c_str(), scene, [](const Units& units) {
    return Avbd{.beta = Avbd{}.beta / units.length, .bounce_threshold = 0.5 * units.speed()};
  });
}

template <class M>
void expect_equalities_same(const char* name, const Scene<M>& scene) {
  const auto unit_free = [&](const char* method_name, const auto& method) {
    expect_same_in_all_units((std::string(name) + ", " + method_name).c_str(), scene,
                             [&](const Units&) { return method; });
  };
  unit_free("direct", AnyStepping{.solver = Direct{}});
  unit_free("dense", AnyStepping{.solver = Direct{Factorisation::dense}});
  unit_free("conjugate gradients", AnyStepping{.solver = ConjugateGradients{}});
  unit_free("RATTLE", Rattle{});
  for (const Scheme scheme : {Scheme::explicit_euler, Scheme::rk4, Scheme::implicit_midpoint})
    unit_free("accelerations", Accelerations{.scheme = scheme});
}

template <class M>
Scene<M> springs() {
  Scene<M> scene;
  int before = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  for (int i = 1; i <= 3; ++i) {
    InverseMass<M> mass{1.0 / i};
    if constexpr (M::angular > 0) mass = ball<M>(i, 0.3);
    const int body = scene.add_body(Linear<M>(1.5 * i * Linear<M>::Unit(0)), mass);
    scene.add(Spring<M>{{before, body}, 1.25, {.stiffness = 40, .damping = 1}});
    before = body;
  }
  return scene;
}

TEST(Units, ChainsOfRods) {
  const auto chain = rod_chain<PlaneParticle>({.links = 5, .angle = 1});
  expect_velocity_stepping_same("rods in the plane", chain);
  // AVBD's stiffness is one of a row whose C is a length.
  expect_positions_same("rods in the plane",
                        rod_chain<PlaneParticle, NormalisedDistance>({.links = 5, .angle = 1}));
  expect_equalities_same("rods in the plane", chain);
  const auto in_space = rod_chain<SpaceParticle>({.links = 4, .angle = 1});
  expect_velocity_stepping_same("rods in space", in_space);
  expect_positions_same("rods in space", rod_chain<SpaceParticle, NormalisedDistance>({.links = 4, .angle = 1}));
  expect_equalities_same("rods in space", in_space);
}

TEST(Units, ChainsOfPins) {
  const auto chain = pinned_chain<PlaneBody>({.links = 5, .angle = 1});
  expect_velocity_stepping_same("pins in the plane", chain);
  expect_positions_same("pins in the plane", chain);
  expect_equalities_same("pins in the plane", chain);
  const auto in_space = pinned_chain<SpaceBody>({.links = 4, .angle = 1});
  expect_velocity_stepping_same("pins in space", in_space);
  expect_positions_same("pins in space", in_space);
  expect_equalities_same("pins in space", in_space);
}

TEST(Units, Springs) {
  expect_velocity_stepping_same("springs", springs<PlaneParticle>());
  expect_positions_same("springs", springs<PlaneParticle>());
  expect_velocity_stepping_same("springs of bodies", springs<SpaceBody>());
  expect_positions_same("springs of bodies", springs<SpaceBody>());
}

TEST(Units, Tops) {
  const auto top = free_top({1, 2, 3}, {0.1, 8, 0.2});
  for (const Gyroscopic gyroscopic : {Gyroscopic::none, Gyroscopic::implicit})
    expect_same_in_all_units("free top", top, [&](const Units&) { return AnyStepping{.gyroscopic = gyroscopic}; });
  expect_equalities_same("free top", top);
}

TEST(Units, Piles) {
  for (const int seed : {3, 7}) {
    expect_velocity_stepping_same("pile in the plane", box_pile<PlaneBody>(seed, {.decades = 1}));
    expect_velocity_stepping_same("pile in space", box_pile<SpaceBody>(seed, {.decades = 1}));
    expect_positions_same("pile in the plane", box_pile<PlaneBody>(seed, {.decades = 1}));
    expect_positions_same("pile in space", box_pile<SpaceBody>(seed, {.decades = 1}));
  }
  expect_velocity_stepping_same("stack", stack<PlaneBody>(6, 10));
}

}  // namespace units_test
