#include <gtest/gtest.h>

#include <map>

#include "lessons/methods/method.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/friction.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/each_cure.hpp"
#include "tests/solver/solving.hpp"

// Whatever is done to a scene while it runs, its next step is that of a simulation built anew from the same state.
namespace changes_test {

using namespace byhand;

template <class M>
using TurnMotor = Motor<M, Turn>;
template <class M>
using TurnLimit = Limit<M, Turn>;

/// The same scene, built anew.
template <class M>
Scene<M> built_anew(const Scene<M>& scene) {
  Scene<M> result = bodies_alone(scene);
  result.gravity = scene.gravity;
  for (std::size_t i = 0; i < scene.bodies().forces.size(); ++i) {
    if (!scene.bodies().has(static_cast<int>(i))) continue;
    const BodyForces& own = scene.bodies().forces[i];
    result.set_damping(static_cast<int>(i), own.linear_damping, own.angular_damping);
    result.set_gravity_scale(static_cast<int>(i), own.gravity_scale);
  }
  std::map<int, int> contacts;  // handles there and here
  const auto add = [&](auto constraint, int place) {
    if constexpr (requires { constraint.contact; }) constraint.contact = contacts.at(constraint.contact);
    contacts[scene.entries()[place].id] = result.add(constraint);
  };
  if constexpr (M::angular > 0) {
    const Colliders<M>& all = scene.colliders();
    for (std::size_t i = 0; i < all.shapes.size(); ++i)
      if (scene.bodies().has(static_cast<int>(i)))
        result.set_shape(static_cast<int>(i), all.shapes[i], all.surfaces[i]);
    result.set_margin(all.margin, all.lookahead);
    result.set_contact_rows(all.rows);
    for_each_of<Distance, NormalisedDistance, Pin, Spring, Rope, Contact, Friction, Weld, TurnMotor, TurnLimit>(
        scene, add);
  } else {
    for_each_of<Distance, NormalisedDistance, Pin, Spring, Rope, Contact, Friction>(scene, add);
  }
  return result;
}

template <class M>
std::vector<double> state_of(const Scene<M>& scene) {
  std::vector<double> result = numbers_of<M>(scene.bodies().velocity);
  for (const Pose<M>& pose : scene.bodies().pose) {
    result.insert(result.end(), pose.position.begin(), pose.position.end());
    if constexpr (M::angular == 1) result.insert(result.end(), {pose.rotation.cos, pose.rotation.sin});
    if constexpr (M::angular == 3)
      result.insert(result.end(), pose.rotation.coeffs().begin(), pose.rotation.coeffs().end());
  }
  return result;
}

/// Makes the next step a cold start, by any solver.
template <class Work>
void forget_impulses(Work& work) {
  for (auto* numbers : {&work.system.lambda, &work.system.stiffness})
    std::fill(numbers->begin(), numbers->end(), 0.0);
  if (!work.system.row_of.empty()) work.contacts.read_impulses(work.system);
  if constexpr (requires { work.cure; })  // P of split impulse
    work.cure.reset();
}

/// One step, and whether it threw.
template <class M, class Method>
std::string step(Simulation<M, Method>& simulation, double h = time_step) {
  try {
    simulation.step(h);
    return {};
  } catch (const std::exception& error) {
    return error.what();
  }
}

AnyStepping any_method(Random& random) {
  const AnyRowSolver solvers[] = {
      GaussSeidel{},
      GaussSeidel{.order = SweepOrder::coloured},
      GaussSeidel{.order = SweepOrder::reverse, .relaxation = 1.2},
      GaussSeidel{.order = SweepOrder::symmetric, .block_solve = BlockSolve::row_by_row},
      Jacobi{.sweeps = 5, .relaxation = 0.3},
      Direct{},
      Direct{Factorisation::dense},
      ConjugateSweeps{},
      ByGraph{},
      ConjugateGradients{},
      AcceleratedGradient{.iterations = 20}};
  const std::vector<DriftCure> cures = tests::each_cure();
  return {.solver = solvers[random.index(std::size(solvers))],
          .drift = cures[random.index(std::size(cures))],
          .substeps = 1 + random.index(2)};
}

/// Random changes of a running simulation. Methods that know equalities alone get no others.
template <class M, class Method>
class Changes {
  static constexpr bool equalities = std::is_same_v<Method, Rattle> || std::is_same_v<Method, Accelerations>;
  static constexpr int most_bodies = 8, most_constraints = 9;

 public:
  explicit Changes(Random& random) : random_(random) {
    for (Simulation<M, Method>& simulation : simulations_) {
      if constexpr (equalities) simulation.method.regularisation = 1e-6;
      for (int i = 0; i < 4; ++i) add_body(simulation.scene);
    }
    saved_ = now().scene;
  }

  /// Makes one random change.
  void change() {
    Scene<M>& scene = now().scene;
    switch (random_.index(18)) {
      case 0: return add_body(scene);
      case 1: return remove_body(scene);
      case 2: return scene.set_pose(any_body(), random_.pose<M>());
      case 3: return scene.set_velocity(any_body(), random_.velocity<M>());
      case 4: return scene.set_mass(any_body(), any_mass());
      case 5:
      case 6: return set_shape(scene);
      case 7: return scene.set_margin(random_.uniform(1e-9, 1e-8), random_.index(2));
      case 8:
        return scene.set_contact_rows(random_.index(2) && M::linear == 2 ? ContactRows::manifold
                                                                         : ContactRows::points);
      case 9:
      case 10:
      case 11: return add_constraint(scene);
      case 12:
        if (scene.count() > 0) scene.remove(scene.entries()[random_.index(scene.count())].id);
        return;
      case 13: return change_constraints(scene);
      case 14: return assign();
      case 15:
        scene.gravity = random_.vector<M::linear>(10);
        h_ = random_.uniform(0.5, 1) * time_step;
        if constexpr (std::is_same_v<Method, AnyStepping>)
          now().method = any_method(random_);
        else if constexpr (std::is_same_v<Method, Avbd>)
          now().method.iterations = 1 + random_.index(5);
        else
          now().method.substeps = 1 + random_.index(4);
        return;
      case 16: return scene.set_damping(any_body(), random_.uniform(0, 5), random_.uniform(0, 5));
      case 17: return scene.set_gravity_scale(any_body(), random_.uniform(-1, 2));
    }
  }

  /// A step of this simulation and one of a simulation that is built anew.
  void expect_as_built_anew() {
    Simulation<M, Method> fresh{built_anew(now().scene), now().method};
    const std::string error = step(now(), h_);
    ASSERT_EQ(step(fresh, h_), error);
    ++(error.empty() ? steps : refusals);
    ASSERT_EQ(difference(state_of(now().scene), state_of(fresh.scene)), 0);
    if (error.empty()) {
      ASSERT_EQ(now().work.system.rows(), fresh.work.system.rows());
      ASSERT_EQ(difference(natural_lambda(now().scene, now().work), natural_lambda(fresh.scene, fresh.work)), 0);
    } else if constexpr (std::is_same_v<Method, AnyStepping>) {
      now().method = any_method(random_);
    } else {  // what cannot be held is taken away
      while (now().scene.count() > 0) now().scene.remove(now().scene.entries()[0].id);
    }
    forget_impulses(now().work);
  }

  /// A few steps without comparison; the last one's impulses are forgotten.
  void run() {
    for (int i = random_.index(3); i > 0; --i) step(now(), h_);
    forget_impulses(now().work);
    for (int body = 0; body < bodies().size(); ++body)  // back to the others what has been flung away
      if (bodies().has(body) &&
          !(bodies().velocity[body].norm() < 20 && bodies().pose[body].position.norm() < 5)) {
        now().scene.set_pose(body, random_.pose<M>());
        now().scene.set_velocity(body, Velocity<M>::Zero());
      }
  }

  int steps = 0, refusals = 0;

 private:
  Simulation<M, Method>& now() { return simulations_[current_]; }
  const Bodies<M>& bodies() { return now().scene.bodies(); }

  int any_body() {
    for (;;)
      if (const int body = random_.index(bodies().size()); bodies().has(body)) return body;
  }
  InverseMass<M> any_mass() { return random_.uniform(0, 1) < 0.3 ? fixed<M>() : random_.mass<M>(); }

  void add_body(Scene<M>& scene) {
    if (scene.bodies().size() - std::ssize(scene.bodies().removed) < most_bodies)
      scene.add_body(random_.pose<M>(), any_mass());
  }
  void remove_body(Scene<M>& scene) {
    if (scene.bodies().size() - std::ssize(scene.bodies().removed) > 3) scene.remove_body(any_body());
  }

  // One body alone may be a box, for of two boxes one keeps the axis that it had before where two will do.
  void set_shape(Scene<M>& scene) {
    if constexpr (M::angular > 0 && !equalities) {
      const int body = any_body();
      const Surface surface{random_.uniform(0, 1), random_.uniform(-0.5, 0.5) < 0 ? 0 : 0.5};
      const int kind = random_.index(4);
      if (kind == 0)
        scene.set_shape(body, {});
      else if (kind == 1 && !moves(bodies().inverse_mass[body]))
        scene.set_shape(body, HalfSpace<M>{random_.direction<M>()}, surface);
      else if (body == 1)
        scene.set_shape(body, Box<M>{Linear<M>(random_.vector<M::linear>(0.4).array() + 0.6)}, surface);
      else
        scene.set_shape(body, Ball<M>{random_.uniform(0.1, 1)}, surface);
    }
  }

  void add_constraint(Scene<M>& scene) {
    const int body1 = any_body(), body2 = any_body();
    if (body1 == body2 || scene.count() >= most_constraints) return;
    const Anchors<M> at = {body1, body2, random_.arms<M>()};
    const double length = at.separation(bodies().pose[body1], bodies().pose[body2]).norm();
    const double softness = equalities ? 0 : random_.uniform(0.01, 0.1);
    const int kind = random_.index(equalities ? 3 : 10);
    if (kind == 0) scene.add(Distance<M>{at, length, softness});
    if (kind == 1) scene.add(NormalisedDistance<M>{at, length, softness});
    if (kind == 2) {
      Pin<M> pin{
          between<M>(scene.bodies(), body1, bodies().pose[body2].position, body2, bodies().pose[body2].position)};
      pin.softness = softness;
      if (M::angular > 0) scene.add(pin);
    }
    if (kind == 3) scene.add(Spring<M>{at, length, {random_.uniform(1, 100), random_.uniform(0, 1)}});
    if (kind == 4) scene.add(Rope<M>{at, length});
    if (kind >= 5 && kind <= 6) {
      const Linear<M> normal = random_.direction<M>();
      const auto contact = scene.add(Contact<M>{.at = at, .normal = normal, .softness = softness});
      if (kind == 6) scene.add(Friction<M>{at, tangents_of<M>(normal), 0.5, contact, softness});
    }
    if constexpr (M::angular > 0) {
      Turn<M> turn{body1, body2};
      if constexpr (M::angular == 3) turn.axis = random_.direction<M>();
      if (kind == 7) scene.add(Weld<M>{at, {}, softness});
      if (kind == 8) scene.add(motor(turn, 1, 5));
      if (kind == 9) scene.add(at_least(0.5, turn));
    }
  }

  void change_constraints(Scene<M>& scene) {
    const double factor = random_.uniform(0.9, 1.1);
    const auto scale = [&](auto& rod) { rod.length *= factor; };
    for (int place = 0; place < scene.count(); ++place)
      if (scene.template get_if<Distance<M>>(place) && random_.index(2))
        scene.change(Handle<Distance<M>>{scene.entries()[place].id}, scale);
    scene.template change_all<NormalisedDistance>(scale);
    scene.template change_all<Spring>(scale);
  }

  /// Scenes and simulations are values.
  void assign() {
    Simulation<M, Method>& other = simulations_[1 - current_];
    switch (random_.index(7)) {
      case 0: saved_ = now().scene; break;
      case 1: now().scene = saved_; break;
      case 2: now().scene = other.scene; break;
      case 3: std::swap(now().scene, other.scene); break;
      case 4: other = now(); break;
      case 5: now().scene = built_anew(saved_); break;
      case 6: current_ = 1 - current_; break;
    }
  }

  Random& random_;
  std::array<Simulation<M, Method>, 2> simulations_ = {};
  int current_ = 0;
  double h_ = time_step;
  Scene<M> saved_;
};

// Sanitized, ten thousand changes take minutes.
#ifdef BYHAND_SANITIZED
constexpr int standard = 1000;
#else
constexpr int standard = 5000;
#endif

template <class Method>
void expect_steps_as_built_anew(int changes_in_all = standard) {
  in_all_models([&]<class M>(Random& random) {
    Changes<M, Method> changes(random);
    for (int count = 0; count < changes_in_all;) {
      changes.run();
      for (const int last = count + 1 + random.index(3); count < last; ++count) changes.change();
      SCOPED_TRACE(testing::Message() << "after " << count << " changes");
      changes.expect_as_built_anew();
      if (testing::Test::HasFailure()) return;
    }
    EXPECT_GT(changes.steps, 10 * changes.refusals);
  });
}

TEST(AnyChanges, OfVelocityStepping) { expect_steps_as_built_anew<AnyStepping>(); }
TEST(AnyChanges, OfXpbd) { expect_steps_as_built_anew<Xpbd>(); }
TEST(AnyChanges, OfAvbd) { expect_steps_as_built_anew<Avbd>(); }
// Its equations are not linear: a step after a change takes up to a hundred solves.
TEST(AnyChanges, OfRattle) { expect_steps_as_built_anew<Rattle>(standard / 5); }
TEST(AnyChanges, OfAccelerations) { expect_steps_as_built_anew<Accelerations>(); }

TEST_IN_ALL_MODELS(MovedScene, LeavesAnEmptyOneThatStepsAndIsFilledAnew) {
  const auto check = [&](const auto& method) {
    Simulation simulation{rod_chain<M>({.links = 3, .angle = 1}), method};
    simulation.step(time_step);
    const Scene<M> taken = std::move(simulation.scene);
    EXPECT_EQ(taken.count(), 3);
    EXPECT_EQ(simulation.scene.bodies().size(), 0);
    EXPECT_EQ(simulation.scene.count(), 0);
    simulation.step(time_step);
    simulation.scene.add_body(random.pose<M>(), random.mass<M>());
    simulation.step(time_step);
    simulation.scene = taken;
    forget_impulses(simulation.work);
    Simulation fresh{built_anew(taken), method};
    EXPECT_EQ(step(simulation), step(fresh));
    EXPECT_EQ(difference(state_of(simulation.scene), state_of(fresh.scene)), 0);
  };
  check(AnyStepping{});
  check(AnyStepping{GaussSeidel{}});
  check(Xpbd{});
  check(Avbd{});
  check(Rattle{});
  check(Accelerations{});
}

/// A ball that rests on the ground.
template <class M>
int add_resting_ball(Scene<M>& scene, double mass) {
  const int body = scene.add_body(Linear<M>(0.5 * Linear<M>::Unit(1)), ball<M>(mass, 0.5));
  scene.set_shape(body, Ball<M>{0.5});
  return body;
}

TEST_IN_BOTH_BODIES(ContactImpulses, AreNotHandedToABodyThatTakesTheNumberOfAnother) {
  Scene<M> scene;
  scene.set_shape(scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>()), HalfSpace<M>{Linear<M>::Unit(1)});
  add_resting_ball(scene, 1e3);
  Simulation<M, AnyStepping> simulation{scene, {GaussSeidel{.sweeps = 1, .relaxation = 0.5}}};
  for (int i = 0; i < 10; ++i) simulation.step(time_step);
  Simulation<M, AnyStepping> replaced = simulation, assigned = simulation;
  replaced.scene.remove_body(1);
  ASSERT_EQ(add_resting_ball(replaced.scene, 1e-3), 1);
  assigned.scene = built_anew(replaced.scene);
  Simulation<M, AnyStepping> fresh{built_anew(replaced.scene), simulation.method};
  for (auto* it : {&replaced, &assigned, &fresh}) it->step(time_step);
  EXPECT_EQ(difference(state_of(replaced.scene), state_of(fresh.scene)), 0);
  EXPECT_EQ(difference(state_of(assigned.scene), state_of(fresh.scene)), 0);
}

TEST(AddedConstraint, MayBeOneThatTheSceneAlreadyHas) {
  Scene<PlaneParticle> scene;
  scene.add_body({0, 0}, fixed<PlaneParticle>());
  scene.add_body({1, 0}, with_mass<PlaneParticle>(1));
  const auto rod = scene.add(Distance<PlaneParticle>{{0, 1}, 1});
  for (int i = 0; i < 20; ++i) scene.add(scene.get(rod));  // its store grows beneath the reference
  for (const auto& entry : scene.entries()) {
    EXPECT_EQ(entry.body1, 0);
    EXPECT_EQ(entry.body2, 1);
  }
}

TEST(ChangedConstraint, IsTheOneThatWasNamedEvenIfOthersComeOrGoMeanwhile) {
  Scene<PlaneParticle> scene;
  scene.add_body({0, 0}, fixed<PlaneParticle>());
  scene.add_body({1, 0}, with_mass<PlaneParticle>(1));
  const auto first = scene.add(Distance<PlaneParticle>{{0, 1}, 1}),
             rod = scene.add(Distance<PlaneParticle>{{0, 1}, 2});
  scene.change(rod, [&](auto& changed) {
    changed.length = 3;
    for (int i = 0; i < 20; ++i) scene.add(Distance<PlaneParticle>{{0, 1}, 7});
    scene.remove(first);
  });
  EXPECT_EQ(scene.get(rod).length, 3);
  EXPECT_EQ(scene.count(), 21);
  int left = 3;
  scene.change_all<Distance>([&](auto& changed) {
    changed.length = 5;
    if (left-- > 0) scene.add(Distance<PlaneParticle>{{0, 1}, 7});
  });
  EXPECT_EQ(scene.get(rod).length, 5);
  EXPECT_EQ(scene.count(), 24);
  EXPECT_EQ(scene.all<Distance>().back().length, 7);
  // All are changed, or none: the last one is no more when all are to be written.
  EXPECT_THROW(scene.change_all<Distance>([&](auto& changed) {
    changed.length = 6;
    if (scene.has(rod)) scene.remove(scene.entries().back().id);
  }),
               std::invalid_argument);
  for (const auto& other : scene.all<Distance>()) EXPECT_NE(other.length, 6);
}

// What is given to a scene may lie in it, and the scene may grow.
TEST(Scene, TakesItsOwnBodiesAndShapesForNewOnes) {
  using M = PlaneBody;
  Scene<M> scene;
  scene.add_body({1, 2}, box<M>(2, {1, 1}), {3, 4, 5});
  scene.set_shape(0, Box<M>{{1, 1}}, {0.25, 0.5}, {.in = 4});
  for (int i = 1; i < 100; ++i) {
    const int body =
        scene.add_body(scene.bodies().pose[0], scene.bodies().inverse_mass[0], scene.bodies().velocity[0]);
    scene.set_shape(body, scene.colliders().shapes[0], scene.colliders().surfaces[0], scene.colliders().layers[0]);
    EXPECT_EQ(scene.bodies().pose[body].position, Linear<M>(1, 2));
    EXPECT_EQ(scene.bodies().velocity[body], Velocity<M>(3, 4, 5));
    EXPECT_EQ(scene.bodies().inverse_mass[body].linear, 0.5);
    EXPECT_EQ(std::get<Box<M>>(scene.colliders().shapes[body]).sides, Linear<M>(1, 1));
    EXPECT_EQ(scene.colliders().surfaces[body].friction, 0.25);
    EXPECT_EQ(scene.colliders().layers[body].in, 4);
  }
  EXPECT_EQ(scene.get_if<Distance<M>>(0), nullptr);
  EXPECT_EQ(scene.get_if<Distance<M>>(-1), nullptr);
}

// A simulation's scene may be replaced; what it found before is not of the new one.
TEST(Simulation, ForgetsTheContactsOfBodiesThatAreNoMore) {
  using M = PlaneBody;
  Scene<M> scene;
  scene.set_shape(scene.add_body({0, 0}, fixed<M>()), HalfSpace<M>{});
  scene.set_shape(scene.add_body({0, 0.4}, box<M>(1, {1, 1})), Box<M>{{1, 1}});
  Simulation simulation{std::move(scene)};
  simulation.step(1.0 / 60);
  EXPECT_EQ(simulation.touches().size(), 1);
  EXPECT_GT(position_error(simulation).max, 0);
  simulation.scene.remove_body(1);
  EXPECT_TRUE(simulation.touches().empty());
  EXPECT_EQ(simulation.scene.add_body({9, 9}, box<M>(1, {1, 1})), 1) << "another body with its index";
  EXPECT_TRUE(simulation.touches().empty());
  simulation.step(1.0 / 60);
  EXPECT_TRUE(simulation.parted().empty());
  simulation.scene = {};
  EXPECT_TRUE(simulation.touches().empty());
  EXPECT_EQ(position_error(simulation).max, 0);
}

}  // namespace changes_test
