#include "solver/scene.hpp"

#include <gmock/gmock.h>

#include "lessons/methods/method.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "solver/constraints/friction.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/solving.hpp"

// A scene that is changed while it runs: handles, warm start, and no row of what is gone.
namespace scene_test {

using namespace byhand;
using testing::AllOf, testing::HasSubstr, testing::StartsWith, testing::ThrowsMessage;

/// Expects one sentence that begins so and says what is allowed, and a scene that is laid out as before.
template <class M>
void expect_refusal(Scene<M>& scene, const std::string& start, const std::string& allowed,
                    const std::function<void()>& call) {
  const auto version = scene.version();
  const int count = scene.count();
  EXPECT_THAT(call, ThrowsMessage<std::invalid_argument>(
                        AllOf(StartsWith(start), HasSubstr(", but it must be "), HasSubstr(allowed))));
  EXPECT_EQ(scene.version(), version);
  EXPECT_EQ(scene.count(), count);
}

template <class M>
std::vector<double> poses_of(const Bodies<M>& bodies) {
  std::vector<double> result;
  for (const Pose<M>& pose : bodies.pose) {
    result.insert(result.end(), pose.position.begin(), pose.position.end());
    if constexpr (M::angular == 1) result.insert(result.end(), {pose.rotation.cos, pose.rotation.sin});
    if constexpr (M::angular == 3)
      result.insert(result.end(), pose.rotation.coeffs().begin(), pose.rotation.coeffs().end());
  }
  return result;
}

template <class M, class Method>
void expect_same_motion(Simulation<M, Method> one, Simulation<M, Method> other, double tolerance = 0) {
  for (int i = 0; i < 30; ++i) {
    one.step(time_step);
    other.step(time_step);
    ASSERT_LE(difference(poses_of(one.scene.bodies()), poses_of(other.scene.bodies())), tolerance) << "step " << i;
    ASSERT_LE(difference(numbers_of<M>(one.scene.bodies().velocity), numbers_of<M>(other.scene.bodies().velocity)),
              tolerance)
        << "step " << i;
  }
}

template <class M>
Scene<M> free_bodies(Random& random, int count) {
  Scene<M> scene;
  for (int i = 0; i < count; ++i) scene.add_body(random.pose<M>(), random.mass<M>(), random.velocity<M>());
  return scene;
}

TEST(Handles, NameTheirConstraintsWhateverIsAddedAndRemoved) {
  struct Rod {
    int id, body1, body2;
    double length;  // 0 for a pin
  };
  in_all_models([]<class M>(Random& random) {
    Scene<M> scene = free_bodies<M>(random, 8);
    std::vector<Rod> known;
    std::vector<int> gone;
    const auto forget = [&](auto&& condition) {
      for (const Rod& rod : known)
        if (condition(rod)) gone.push_back(rod.id);
      std::erase_if(known, condition);
    };
    for (int round = 0; round < 300; ++round) {
      const int body1 = random.index(8), body2 = (body1 + 1 + random.index(7)) % 8;
      const double length = random.uniform(0.5, 2), what = random.uniform(0, 1);
      if (what < 0.35)
        known.push_back({scene.add(Distance<M>{{body1, body2}, length}), body1, body2, length});
      else if (what < 0.6)
        known.push_back({scene.add(Pin<M>{{body1, body2}}), body1, body2, 0});
      else if (what < 0.95 && !known.empty()) {
        const int id = known[random.index(static_cast<int>(known.size()))].id;
        scene.remove(id);
        forget([&](const Rod& rod) { return rod.id == id; });
      } else {
        scene.remove_body(body1);
        forget([&](const Rod& rod) { return rod.body1 == body1 || rod.body2 == body1; });
        EXPECT_EQ(scene.add_body(random.pose<M>(), random.mass<M>()), body1) << "its index is used again";
      }
      ASSERT_EQ(scene.count(), static_cast<int>(known.size()));
      for (int place = 0; place < scene.count(); ++place) {
        const Rod& rod = known[place];
        ASSERT_TRUE(scene.has(rod.id));
        ASSERT_EQ(scene.place(rod.id), place) << "in the order in which they came";
        ASSERT_EQ(scene.entries()[place].body1, rod.body1);
        ASSERT_EQ(scene.entries()[place].body2, rod.body2);
        if (rod.length > 0) {
          ASSERT_EQ(scene.get(Handle<Distance<M>>{rod.id}).length, rod.length);
        }
      }
      ASSERT_EQ(scene.template all<Distance>().size() + scene.template all<Pin>().size(), known.size());
      for (const int id : gone) ASSERT_FALSE(scene.has(id));
    }
    EXPECT_GT(known.size(), 3u);
    Work<M> work;
    advance(scene, {GaussSeidel{}}, time_step, work);
    EXPECT_EQ(work.system.row_of.size(), known.size());
  });
}

TEST(Handles, OfWhatIsGoneUnknownOrAnotherKindAreRefused) {
  using M = PlaneBody;
  Simulation<M> simulation{pinned_chain<M>({.links = 3}), {}};
  Scene<M>& scene = simulation.scene;
  const auto rod = scene.add(Distance<M>{{0, 2}, 1});
  const auto gone = scene.add(Distance<M>{{0, 3}, 1});
  scene.remove(gone);
  const std::string has = "one that this scene has", name = "constraint is ";
  for (const int id : {static_cast<int>(gone), 77, -1}) {
    const std::string start = name + std::to_string(id);
    const Handle<Distance<M>> handle{id};
    expect_refusal(scene, start, has, [&] { scene.remove(id); });
    expect_refusal(scene, start, has, [&] { scene.change(handle, [](auto&) {}); });
    expect_refusal(scene, start, has, [&] { scene.get(handle); });
    expect_refusal(scene, start, has, [&] { scene.place(id); });
    expect_refusal(scene, start, has, [&] { simulation.reaction(id); });
  }
  const Handle<Pin<M>> wrong{rod};
  expect_refusal(scene, "constraint is 3", "of the kind of its handle", [&] { scene.get(wrong); });
  expect_refusal(scene, "constraint is 3", "of the kind of its handle",
                 [&] { scene.change(wrong, [](auto&) {}); });
  expect_refusal(scene, "constraint is 3", "one that took part in the last step",
                 [&] { simulation.reaction(rod); });
  simulation.step(time_step);
  EXPECT_NO_THROW(simulation.reaction(rod));
}

TEST(BodyIndices, OfWhatIsGoneOrUnknownAreRefused) {
  using M = PlaneBody;
  Scene<M> scene = pinned_chain<M>({.links = 3});
  scene.remove_body(2);
  const auto refused = [&](int body, const std::string& allowed) {
    const std::string start = "body index is " + std::to_string(body);
    expect_refusal(scene, start, allowed, [&] { scene.remove_body(body); });
    expect_refusal(scene, start, allowed, [&] { scene.set_pose(body, {}); });
    expect_refusal(scene, start, allowed, [&] { scene.set_position(body, {0, 0}); });
    expect_refusal(scene, start, allowed, [&] { scene.set_velocity(body, {0, 0, 0}); });
    expect_refusal(scene, start, allowed, [&] { scene.set_mass(body, fixed<M>()); });
    expect_refusal(scene, start, allowed, [&] { scene.set_shape(body, Ball<M>{1}); });
    expect_refusal(scene, start, allowed, [&] { scene.add(Pin<M>{{body, 1}}); });
    expect_refusal(scene, start, allowed, [&] { pin<M>(scene.bodies(), 1, body, {0, 0}); });
  };
  refused(2, "that of a body that was not removed");
  Scene<M> empty;
  empty.add_body({0, 0}, ball<M>(1, 1));
  empty.remove_body(0);
  expect_refusal(empty, "body index is 0", "that of a body that was not removed", [&] { empty.remove_body(0); });
  refused(4, "at least 0 and less than 4, the number of bodies");
  refused(-1, "at least 0 and less than 4, the number of bodies");
  const Pose<M> before = scene.bodies().pose[1];
  const double nan = std::nan("");
  expect_refusal(scene, "position is nan", "finite", [&] { scene.set_position(1, {nan, 0}); });
  expect_refusal(scene, "velocity is nan", "finite", [&] { scene.set_velocity(1, {0, 0, nan}); });
  expect_refusal(scene, "inverse mass is -1", "positive", [&] { scene.set_mass(1, {-1, Angular<M>(1)}); });
  EXPECT_EQ(scene.bodies().pose[1].position, before.position);
  EXPECT_TRUE(scene.bodies().velocity[1].isZero(0));
  EXPECT_GT(scene.bodies().inverse_mass[1].linear, 0);
}

TEST(Change, TakesEffectInTheNextStepAndKeepsTheWarmStart) {
  using M = PlaneParticle;
  Simulation<M> simulation{pendulum<M, NormalisedDistance>(0, 2, 3), {GaussSeidel{}, Baumgarte{1}}};
  const Handle<NormalisedDistance<M>> rod{simulation.scene.entries()[0].id};
  simulation.step(time_step);
  const auto version = simulation.scene.version();
  simulation.scene.change(rod, [](auto& it) { it.length = 2.5; });
  EXPECT_EQ(simulation.scene.version(), version) << "nothing has to be laid out anew";
  simulation.step(time_step);
  EXPECT_NEAR(simulation.scene.bodies().pose[1].position.norm(), 2.5, 1e-14);
}

TEST_IN_ALL_MODELS(Change, ToWhatIsInvalidThrowsAndLeavesTheSceneAsItWas) {
  Scene<M> scene = rod_chain<M>({.links = 3});
  const Handle<Distance<M>> rod{scene.entries()[1].id};
  const auto refused = [&](auto change, const std::string& start, const std::string& allowed) {
    expect_refusal(scene, start, allowed, [&] { scene.change(rod, change); });
    EXPECT_EQ(scene.get(rod).length, 1);
    EXPECT_EQ(scene.get(rod).at.body1, 1);
    EXPECT_EQ(scene.get(rod).at.body2, 2);
  };
  refused([](auto& it) { it.length = -1; }, "length is -1", "positive");
  refused([](auto& it) { it.at.body1 = 0; }, "first body of a changed constraint is 0", "1, as it was");
  refused([](auto& it) { it.at.body2 = 3; }, "second body of a changed constraint is 3", "2, as it was");
  const auto halve_but_the_last = [&](auto& it) { it.length = it.at.body2 == 3 ? 0.0 : 0.5; };
  expect_refusal(scene, "length is 0", "positive",
                 [&] { scene.template change_all<Distance>(halve_but_the_last); });
  for (const auto& each : scene.template all<Distance>()) EXPECT_EQ(each.length, 1) << "all or none";

  const Linear<M> up = Linear<M>::Unit(1);
  const auto contact = scene.add(Contact<M>{{0, 1}, up}), other = scene.add(Contact<M>{{0, 2}, up});
  const auto friction = scene.add(Friction<M>{{0, 1}, tangents_of<M>(up), 0.5, contact});
  expect_refusal(scene, "contact of a changed constraint is 4", "3, as it was",
                 [&] { scene.change(friction, [&](auto& it) { it.contact = other; }); });
  EXPECT_EQ(scene.get(friction).contact, static_cast<int>(contact));
}

TEST_IN_ALL_MODELS(WarmStart, KeepsTheImpulsesOfThoseThatStayAndGivesNoneToThoseThatCome) {
  for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(GaussSeidel{.order = SweepOrder::coloured}),
                                  RowSolver(GaussSeidel{.order = SweepOrder::reverse})}) {
    Scene<M> scene = random_graph<M>(random, 9, 15);
    Work<M> work;
    advance(scene, {solver}, time_step, work);
    for (int round = 0; round < 20; ++round) {
      std::vector<std::pair<int, double>> before;  // identity and λ of the first row
      for (int place = 0; place < scene.count(); ++place)
        before.push_back({scene.entries()[place].id, work.system.lambda[work.system.row_of[place]]});
      scene.remove(scene.entries()[random.index(scene.count())].id);
      const int body = random.index(9);
      const int come = random.index(2) == 0 ? static_cast<int>(scene.add(Distance<M>{{body, (body + 1) % 9}, 1}))
                                            : static_cast<int>(scene.add(Pin<M>{{body, (body + 1) % 9}}));
      if (round % 5 == 0) scene.set_mass(random.index(9), random.mass<M>());
      lay_out(scene, solver, work);
      const auto lambda = [&](int id) { return work.system.lambda[work.system.row_of[scene.place(id)]]; };
      for (const auto& [id, kept] : before) ASSERT_EQ(scene.has(id) ? lambda(id) : kept, kept);
      ASSERT_EQ(lambda(come), 0);
      advance(scene, {solver}, time_step, work);
      ASSERT_EQ(std::count(work.system.lambda.begin(), work.system.lambda.end(), 0.0) < work.system.rows(), true);
    }
  }
}

TEST(WarmStart, OfAChainAtRestOutlivesChangesElsewhere) {
  using M = PlaneParticle;
  Simulation<M> simulation{rod_chain<M, NormalisedDistance>({.links = 8}), {GaussSeidel{500}}};
  auto& scene = simulation.scene;
  std::vector<int> posts;
  for (int i = 0; i < 5; ++i) posts.push_back(scene.add_body(Linear<M>(9, i), with_mass<M>(1)));
  run(simulation, 1, time_step);
  simulation.method.solver = GaussSeidel{1};
  for (int i = 0; i < 4; ++i) {
    const auto rod = scene.add(Distance<M>{{posts[i], posts[i + 1]}, 1});
    simulation.step(time_step);
    if (i % 2 == 0) scene.remove(rod);
    if (i == 2) scene.remove_body(posts[0]);
    simulation.step(time_step);
  }
  for (int i = 1; i <= 8; ++i) EXPECT_LT(scene.bodies().velocity[i].norm(), 1e-9) << "bob " << i;
}

/// The same scene, built anew.
template <class M>
Scene<M> built_anew(const Scene<M>& scene) {
  Scene<M> result = bodies_alone(scene);
  for_each_of<Distance, Pin>(scene, [&](const auto& constraint, int) { result.add(constraint); });
  const Colliders<M>& all = scene.colliders();
  if constexpr (M::angular > 0)
    for (std::size_t i = 0; i < all.shapes.size(); ++i)
      result.set_shape(static_cast<int>(i), all.shapes[i], all.surfaces[i]);
  return result;
}

const VelocityStepping cold_methods[] = {{Direct{}},
                                         {GaussSeidel{10, false}},
                                         {GaussSeidel{10, false, SweepOrder::coloured}},
                                         {Direct{}, SplitImpulse{.warm_start = false}},
                                         {GaussSeidel{10, false}, SoftConstraints{}}};

TEST_IN_ALL_MODELS(Bodies, FreedFixedOrMadeHeavierMoveAsInASceneThatIsBuiltSo) {
  for (const VelocityStepping& method : cold_methods) {
    Simulation<M> simulation{rod_chain<M>({.links = 6, .angle = 1}), method};
    Scene<M>& scene = simulation.scene;
    const auto expect_as_built = [&] {
      expect_same_motion(simulation, Simulation<M>{built_anew(scene), method});
      run(simulation, 0.2, time_step);
    };
    run(simulation, 0.2, time_step);
    scene.set_mass(3, fixed<M>());
    EXPECT_TRUE(scene.bodies().velocity[3].isZero(0));
    expect_as_built();
    scene.set_mass(3, random.mass<M>());
    scene.set_mass(0, random.mass<M>());
    expect_as_built();
    InverseMass<M> heavy = scene.bodies().inverse_mass[6];
    heavy.linear /= 50;
    if constexpr (M::angular > 0) heavy.angular /= 50;
    scene.set_mass(6, heavy);
    expect_as_built();
  }
}

TEST_IN_BOTH_BODIES(Bodies, FreedFixedMadeHeavierOrRemovedWithinAStackMoveAsInOneThatIsBuiltSo) {
  Simulation<M> simulation{stack<M>(4), {GaussSeidel{60, false}}};
  Scene<M>& scene = simulation.scene;
  // Of boxes in space two faces may draw, and then what was seen before decides which one's points are taken.
  if constexpr (M::linear == 3)
    for (int i = 1; i <= 4; ++i) scene.set_shape(i, Ball<M>{0.5});
  const auto expect_as_built = [&] {
    expect_same_motion(simulation, Simulation<M>{built_anew(scene), simulation.method}, 1e-9);
    run(simulation, 0.3, time_step);
  };
  run(simulation, 0.2, time_step);
  scene.set_mass(2, fixed<M>());
  expect_as_built();
  scene.set_mass(1, box<M>(3, Linear<M>::Ones()));
  expect_as_built();
  scene.set_mass(2, box<M>(5, Linear<M>::Ones()));
  expect_as_built();
  scene.remove_body(3);
  run(simulation, 3, time_step);
  EXPECT_NEAR(scene.bodies().pose[4].position.y(), 2.5, 0.02) << "the topmost fell onto the second";
  EXPECT_EQ(scene.add_body(Linear<M>(3 * Linear<M>::Unit(0)), box<M>(1, Linear<M>::Ones())), 3);
  const auto contacts = simulation.work.contacts.pairs().size();
  simulation.step(time_step);
  EXPECT_EQ(simulation.work.contacts.pairs().size(), contacts)
      << "what takes the place of a body does not take its shape";
}

// Both scenes have as many bodies, constraints and rows.
TEST_IN_ALL_MODELS(AssignedScene, LeavesNoRowOfTheOneBefore) {
  const Scene<M> first = rod_chain<M>({.links = 5, .angle = 1});
  const Scene<M> second =
      rod_chain<M, NormalisedDistance>({.links = 5, .length = 0.5, .end_mass = 9, .angle = 0.3});
  const Scene<M> third = rod_chain<M>({.links = 5, .length = 2, .angle = -2});
  const auto check = [&](const auto& method) {
    Simulation simulation{first, method};
    for (const Scene<M>& next : {second, third, first}) {
      for (int i = 0; i < 3; ++i) simulation.step(time_step);
      simulation.scene = next;
      expect_same_motion(simulation, Simulation{next, method});
    }
  };
  for (const DriftCure& cure : {DriftCure(Baumgarte{}), DriftCure(Projection{}), DriftCure(SplitImpulse{}),
                                DriftCure(SoftConstraints{.refresh = false})})
    for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(Direct{}), RowSolver(ByGraph{}),
                                    RowSolver(GaussSeidel{.order = SweepOrder::coloured})}) {
      SCOPED_TRACE(testing::Message() << "cure " << cure.index() << ", solver " << solver.index());
      check(VelocityStepping{solver, cure});
    }
  check(Xpbd{});
  check(Avbd{});
  check(Rattle{});
  check(Accelerations{});
}

TEST(AssignedScene, ThatIsAnotherCopyDoesNotTakeItsImpulses) {
  using M = PlaneBody;
  const Scene<M> common = pinned_chain<M>({.links = 3, .angle = 1});
  Scene<M> one = common, other = common;
  const int rod = one.add(Distance<M>{{0, 3}, 3}), pin_of_other = other.add(Pin<M>{{0, 3}});
  ASSERT_EQ(rod, pin_of_other) << "the same identity in either";
  Work<M> work;
  advance(one, {GaussSeidel{}}, time_step, work);
  const std::vector<double> before = work.system.lambda;
  lay_out(other, GaussSeidel{}, work);
  for (int row = 0; row < 6; ++row) EXPECT_EQ(work.system.lambda[row], before[row]) << "of what they share";
  EXPECT_EQ(work.system.lambda[6], 0);
  EXPECT_EQ(work.system.lambda[7], 0);
}

TEST(AssignedScene, WithoutShapesLeavesNoContactOfTheOneBefore) {
  using M = PlaneBody;
  const Scene<M> hanging = hinged_rod<M>(1, 2, 3);
  const auto check = [&](const auto& method) {
    Simulation simulation{stack<M>(6), method};
    for (int i = 0; i < 3; ++i) simulation.step(time_step);
    simulation.scene = hanging;
    expect_same_motion(simulation, Simulation{hanging, method});
    simulation.step(time_step);
    simulation.scene = pyramid<M>(2);
    expect_same_motion(simulation, Simulation{pyramid<M>(2), method});
  };
  check(VelocityStepping{});
  check(Xpbd{});
  check(Avbd{});
}

TEST(Copy, OfASimulationRunsOnBitForBitAndByItself) {
  const auto check = [](const auto& scene, const auto& method) {
    Simulation simulation{scene, method};
    run(simulation, 0.2, time_step);
    simulation.scene.remove(simulation.scene.entries()[1].id);
    const int body = simulation.scene.entries()[0].body2;
    simulation.scene.set_mass(body, simulation.scene.bodies().inverse_mass[body]);
    run(simulation, 0.1, time_step);
    const auto copy = simulation;
    expect_same_motion(simulation, copy);
    const auto velocity = copy.scene.bodies().velocity;
    simulation.scene.remove(simulation.scene.entries()[0].id);
    run(simulation, 0.1, time_step);
    EXPECT_EQ(copy.scene.count(), scene.count() - 1);
    EXPECT_EQ(copy.scene.bodies().velocity, velocity);
  };
  in_all_models([&]<class M>(Random&) {
    const Scene<M> chain = rod_chain<M>({.links = 6, .angle = 1});
    for (const RowSolver& solver : {RowSolver(GaussSeidel{}), RowSolver(Direct{}), RowSolver(ByGraph{})})
      check(chain, VelocityStepping{solver, SplitImpulse{}});
    check(chain, Xpbd{});
    check(chain, Avbd{});
    check(chain, Rattle{});
    check(chain, Accelerations{});
  });
  in_both_bodies([]<class M>(Random&) {
    Simulation<M> simulation{stack<M>(4), {}};
    run(simulation, 0.1, time_step);
    simulation.scene.remove_body(2);
    run(simulation, 0.1, time_step);
    expect_same_motion(simulation, Simulation<M>(simulation));
  });
}

TEST_IN_ALL_MODELS(Removal, OfAContactTakesItsFriction) {
  Scene<M> scene = free_bodies<M>(random, 4);
  const Linear<M> up = Linear<M>::Unit(1);
  const auto press = [&](int body1, int body2) { return scene.add(Contact<M>{{body1, body2}, up}); };
  const auto rub = [&](int body1, int body2, int contact) {
    return scene.add(Friction<M>{{body1, body2}, tangents_of<M>(up), 0.5, contact});
  };
  const auto first = press(0, 1), second = press(0, 2);
  const auto of_first = rub(0, 1, first), of_second = rub(0, 2, second), also_of_first = rub(0, 3, first);
  const auto expect_runs = [&] {
    Work<M> work;
    Scene<M> copy = scene;
    EXPECT_NO_THROW(advance(copy, {GaussSeidel{}}, time_step, work));
  };
  scene.remove(of_second);
  EXPECT_TRUE(scene.has(second)) << "a contact stays without its friction";
  expect_runs();
  Scene<M> without_body = scene;
  scene.remove(first);
  EXPECT_FALSE(scene.has(of_first));
  EXPECT_FALSE(scene.has(also_of_first));
  EXPECT_EQ(scene.count(), 1);
  expect_runs();
  // Also where the contact goes with a body that the friction does not hold.
  without_body.remove_body(1);
  EXPECT_FALSE(without_body.has(also_of_first));
  EXPECT_EQ(without_body.count(), 1);
  scene = without_body;
  expect_runs();
}

TEST(FoundContacts, AreNoConstraintsOfTheSceneAndTheirRowsFollowItsOwn) {
  using M = PlaneBody;
  Simulation<M> simulation{by_points(stack<M>(2)), {}};
  Scene<M>& scene = simulation.scene;
  const auto version = scene.version();
  simulation.step(time_step);
  EXPECT_EQ(scene.count(), 0);
  EXPECT_EQ(scene.version(), version) << "what is found changes no scene";
  const auto contacts = [&] { return simulation.work.contacts.constraints().count(); };
  EXPECT_EQ(contacts(), 8) << "four points, each with its friction";
  const Linear<M> up(0, 1);
  expect_refusal(scene, "contact of a friction is 0", "a contact that was added before", [&] {
    scene.add(Friction<M>{{0, 1}, tangents_of<M>(up), 0.5, 0});
  });
  const int rod = scene.add(Distance<M>{{0, 2}, 1.5});
  simulation.step(time_step);
  EXPECT_EQ(scene.entries()[0].id, rod);
  EXPECT_EQ(contacts(), 8);
  const System<M>& system = simulation.work.system;
  EXPECT_EQ(system.rows(), 9);
  EXPECT_EQ(system.row_of.size(), 9u);
  EXPECT_EQ(simulation.impulse(rod)[0], system.lambda[system.row_of[0]]);
}

TEST(FoundContacts, AreFoundAnewWhereASceneOfTheSameVersionComesBack) {
  using M = PlaneBody;
  const Scene<M> piled = stack<M>(3);
  Simulation<M> simulation{piled, {}};
  for (int i = 0; i < 3; ++i) simulation.step(time_step);
  const Scene<M> standing = simulation.scene;
  simulation.scene = hinged_rod<M>(1, 2, 3);
  simulation.step(time_step);
  EXPECT_EQ(simulation.work.contacts.constraints().count(), 0);
  simulation.scene = standing;
  expect_same_motion(simulation, Simulation<M>{standing, simulation.method}, 1e-6);
  simulation.step(time_step);
  EXPECT_EQ(simulation.work.contacts.constraints().count(), 3);
}

}  // namespace scene_test
