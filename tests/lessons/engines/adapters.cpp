#include <gtest/gtest.h>

#include <fstream>
#include <iostream>
#include <map>
#include <set>

#include "lessons/engines/contest.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/incline.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/measure.hpp"

// A wrong adapter would slander an engine. Each engine reproduces what any engine has to, at a step that is short
// enough.
namespace byhand::engines {
namespace adapters_test {

using M = PlaneBody;
constexpr int short_steps = 64;  // a frame

/// In this program, then in WebAssembly.
const std::vector<Engine>& everybody() {
  static const std::vector<Engine> all = [] {
    std::vector<Engine> found = all_engines();
    found.insert(found.end(), engines_in_webassembly().begin(), engines_in_webassembly().end());
    return found;
  }();
  return all;
}

class Adapter : public testing::TestWithParam<int> {
 protected:
  const Engine& engine() const { return everybody().at(GetParam()); }
  /// Whether the engine runs a box on the ground; if not, says why.
  bool lays() const {
    const std::string why = refusal(engine(), stack(1));
    if (!why.empty()) std::cout << engine().name << " " << why << '\n';
    return why.empty();
  }
  template <class Model = M>
  Scene<Model> after(const Scene<Model>& scene, double time, int steps = short_steps) const {
    Scene<Model> end = scene;
    run<Model>(contestant<Model>(engine(), {.steps = steps}), scene, static_cast<int>(std::lround(time / frame)),
               [&](const Scene<Model>& seen, double) { end = seen; });
    return end;
  }
};

TEST_P(Adapter, FallsByHalfGTSquared) {
  Scene<M> scene;
  const Velocity<M> thrown(3, 0, 2);
  scene.add_body(Linear<M>(1, 5), box<M>(2, {1, 0.5}), thrown);
  const Scene<M> end = after(scene, 0.5);
  const Pose<M>& pose = end.bodies().pose[0];
  const double rounding = engine().single ? 5e-4 : 1e-9;  // 30 · 64 steps, in each of which Rapier has four
  EXPECT_NEAR(pose.position.x(), 1 + 3 * 0.5, rounding);
  EXPECT_NEAR(pose.position.y(), 5 - 0.5 * 9.81 * 0.25, 9.81 * 0.5 * frame / short_steps)
      << "half a step more or less";
  EXPECT_NEAR(std::atan2(pose.rotation.sin, pose.rotation.cos), 1, 1e-4);
  EXPECT_NEAR(end.bodies().velocity[0].y(), -9.81 * 0.5, 1e-4);
}

TEST_P(Adapter, SwingsARodOnAPinAsTheEllipticIntegralSays) {
  const Scene<M> end = after(hinged_rod(1, 1.5, 2), 1);
  const PlaneRotation<double> turned = end.bodies().pose[1].rotation;
  const CompoundPendulum exact(1, 1.5, 2, 9.81);
  EXPECT_NEAR(std::atan2(turned.sin, turned.cos), exact.angle(1), 0.01 * std::abs(exact.angle(1)));
  EXPECT_NEAR(end.bodies().velocity[1][2], exact.angular_velocity(1), 0.01 * std::abs(exact.angular_velocity(1)));
  EXPECT_LT(position_error(end).max, 1e-3);
}

TEST_P(Adapter, SwingsABobOnARodAsTheEllipticIntegralSays) {
  if (const std::string why = refusal(engine(), pendulum<M>(1, 1.5, 2)); !why.empty())
    GTEST_SKIP() << engine().name << " " << why;
  const Scene<M> end = after(pendulum<M>(1, 1.5, 2), 1);
  const Linear<M> bob = end.bodies().pose[1].position;
  const SimplePendulum exact(1, 1.5, 9.81);
  EXPECT_NEAR(std::atan2(bob.x(), -bob.y()), exact.angle(1), 0.01 * std::abs(exact.angle(1)));
  EXPECT_NEAR(bob.norm(), 1.5, 1e-3);
}

TEST_P(Adapter, LaysABoxOnTheGroundWhereItIs) {
  if (!lays()) GTEST_SKIP();
  const Scene<M> end = after(stack(1), 1, 4);
  EXPECT_NEAR(end.bodies().pose[1].position.y(), 0.5, 0.006) << "the slop of Box2D is 5 mm";
  EXPECT_NEAR(end.bodies().pose[1].position.x(), 0, 1e-4);
}

TEST_P(Adapter, TakesNewVelocitiesInItsOwnRest) {
  if (!lays()) GTEST_SKIP();
  const Scene<M> start = stack(1);
  Scene<M> end = start;
  const Start<M> at_rest{30, [](Scene<M>& rest) {
                           rest.state().velocity[1] = {0, 3, 0.5};
                           return true;
                         }};
  run_from<M>(at_rest, contestant<M>(engine(), {.steps = 4}), start, 3, [&](const Scene<M>& seen, double time) {
    EXPECT_NEAR(seen.bodies().velocity[1].y(), 3 - 9.81 * time, 0.05);
    EXPECT_NEAR(seen.bodies().velocity[1][2], 0.5, 0.01);
    end = seen;
  });
  EXPECT_GT(end.bodies().pose[1].position.y(), 0.55);
}

/// Every knob that a setting turns has to change something: the engine would be slandered by a name that its
/// adapter does not know.
TEST_P(Adapter, KnowsEveryKnobThatIsTurned) {
  if (engine().file == this_course().file) GTEST_SKIP() << "a stack of this course needs no sweeps";
  const auto without = [](const std::string& name, Setting setting) {
    auto turned = setting.knobs.turned();
    std::erase_if(turned, [&](const auto& knob) { return knob.first == name; });
    setting.knobs = Knobs(turned);
    return setting;
  };
  const auto end_of = [&](const Scene<M>& scene, const Setting& setting) {
    Bodies<M> end;
    run<M>(contestant<M>(engine(), setting), scene, 12,
           [&](const Scene<M>& seen, double) { end = seen.bodies(); });
    std::vector<double> numbers;
    for (const Velocity<M>& V : end.velocity) numbers.insert(numbers.end(), V.begin(), V.end());
    return numbers;
  };
  Scene<M> touching = box_on_incline(0.3, 0.4);
  touching.state().velocity[1] = {0.3, -1, 0.2};
  if (refusal(engine(), stack(3)).empty()) {
    touching = stack(3, 20);
    touching.set_position(2, Linear<M>(0.1, 1.4));
    touching.state().velocity[3] = {0.3, -1, 0.2};
  }
  const Scene<M> chain = pinned_chain<M>({.links = 5, .end_mass = 20, .angle = 1.5});
  if (!refusal(engine(), touching).empty()) touching = chain;
  for (const auto& [settings, scene] :
       {std::pair{engine().settings.joints, chain}, {engine().settings.contacts, touching}}) {
    std::map<std::string, bool> matters;
    for (const Setting& setting : settings)
      for (const auto& [name, value] : setting.knobs.turned())
        matters[name] = matters[name] || end_of(scene, setting) != end_of(scene, without(name, setting));
    for (const auto& [name, changes] : matters) EXPECT_TRUE(changes) << name;
  }
}

TEST_P(Adapter, LetsABoxSlideAsCoulombSays) {
  if (!lays()) GTEST_SKIP();
  const double slope = 0.5, friction = 0.3, time = 0.5;
  const Scene<M> start = box_on_incline(slope, friction);
  const Scene<M> end = after(start, time, 16);
  const double way = (end.bodies().pose[1].position - start.bodies().pose[1].position).norm(),
               exact = 0.5 * 9.81 * (std::sin(slope) - friction * std::cos(slope)) * time * time;
  EXPECT_NEAR(way, exact, 0.03 * exact);
}

TEST_P(Adapter, LeavesABoxOnASlopeThatFrictionHolds) {
  if (!lays()) GTEST_SKIP();
  const Scene<M> start = box_on_incline(0.2, 0.3);
  const Scene<M> end = after(start, 0.5, 16);
  EXPECT_LT((end.bodies().pose[1].position - start.bodies().pose[1].position).norm(), 0.01);
}

TEST_P(Adapter, LaysAndSwingsInSpaceToo) {
  using S = SpaceBody;
  if (engine().home == Home::plane) GTEST_SKIP() << engine().name << " knows the plane alone";
  if (lays()) {
    const Scene<S> lying = after<S>(stack<S>(1), 1, 4);
    EXPECT_LT((lying.bodies().pose[1].position - stack<S>(1).bodies().pose[1].position).norm(), 0.006);
  }
  const Scene<S> swung = after<S>(hinged_rod<S>(1, 1.5, 2), 1);
  const Linear<S> middle = swung.bodies().pose[1].position;
  const CompoundPendulum exact(1, 1.5, 2, 9.81);
  EXPECT_NEAR(std::atan2(middle.x(), -middle.y()), exact.angle(1), 0.01 * std::abs(exact.angle(1)));
}

INSTANTIATE_TEST_SUITE_P(Each, Adapter, testing::Range(0, static_cast<int>(everybody().size())),
                         [](const auto& tested) {
                           std::string name = everybody()[tested.param].name;
                           std::erase_if(name, [](char c) { return !std::isalnum(c); });
                           return name;
                         });
GTEST_ALLOW_UNINSTANTIATED_PARAMETERIZED_TEST(Adapter);

// Why its contacts take no part: four points of a face repeat each other.
TEST(Engines, OdeDirectLetsAStackOfTenFall) {
  const auto direct = std::ranges::find(all_engines(), "ODE direct", &Engine::name);
  if (direct == all_engines().end()) GTEST_SKIP();
  for (const Setting& setting : {direct->settings.contacts[0], direct->settings.contacts[1]}) {
    double lowest = 10;
    run<M>(contestant<M>(*direct, setting), stack(10), 60,
           [&](const Scene<M>& seen, double) { lowest = std::min(lowest, seen.bodies().pose[10].position.y()); });
    EXPECT_LT(lowest, 9) << setting.knobs.words();
  }
}

TEST(Engines, EachIsThereOrNamedAsMissing) {
  EXPECT_GE(all_engines().size() + missing().size(), 7U);
  EXPECT_EQ(engines_in_webassembly().size() + missing_in_webassembly().size(), 7U);
  for (const Engine& engine : everybody()) {
    EXPECT_FALSE(engine.version.empty());
    EXPECT_TRUE(std::ifstream(std::string(BYHAND_ROOT) + "/" + engine.file).good()) << engine.file;
    EXPECT_EQ(std::count(missing().begin(), missing().end(), engine.name), 0);
  }
}

TEST(Engines, EachHasOneShippedSettingThenOneAdvisedWithItsSource) {
  std::vector<Engine> all = everybody();
  all.push_back(this_course());
  for (const Engine& engine : all)
    for (const auto* settings : {&engine.settings.joints, &engine.settings.contacts}) {
      ASSERT_GE(settings->size(), 3U) << engine.name;
      for (std::size_t i = 0; i < settings->size(); ++i) {
        const Setting& setting = (*settings)[i];
        EXPECT_EQ(setting.row, i == 0 ? Row::shipped : i == 1 ? Row::advised : Row::tuned) << engine.name;
        EXPECT_EQ(setting.source.empty(), setting.row != Row::advised) << engine.name;
      }
      EXPECT_TRUE(settings->front().knobs.turned().empty()) << engine.name << " is not as it is shipped";
    }
}

TEST(Engines, ThatAreComparedOnPinsOnlySaySoInTheSameWords) {
  for (const Engine& engine : everybody()) {
    const std::string rods = refusal(engine, pendulum<M>(1, 1.5, 2));
    EXPECT_TRUE(rods.empty() || rods == "compared on pins, not on rods" ||
                rods.starts_with("no rigid distance joint"))
        << engine.name << ": " << rods;
    EXPECT_EQ(refusal(engine, hinged_rod(1, 1.5, 2)), "") << engine.name;
  }
}

TEST(ThisCourseInWebAssembly, MovesAsItDoesInThisProgram) {
  if (engines_in_webassembly().empty()) GTEST_SKIP();
  const auto places_after_a_second = []<class Model>(const Engine& engine, const Scene<Model>& scene) {
    std::vector<double> numbers;
    run<Model>(contestant<Model>(engine, engine.settings.contacts.front()), scene, 60,
               [&](const Scene<Model>& seen, double) {
                 numbers.clear();
                 for (const auto& pose : seen.bodies().pose)
                   numbers.insert(numbers.end(), pose.position.begin(), pose.position.end());
               });
    return numbers;
  };
  const auto expect_same = [&](const auto& scene) {
    EXPECT_EQ(places_after_a_second(engines_in_webassembly().front(), scene),
              places_after_a_second(this_course(), scene));
  };
  expect_same(pyramid<PlaneBody>(4));
  expect_same(pyramid<SpaceBody>(4));
  expect_same(pinned_chain<SpaceBody>({.links = 5, .end_mass = 20, .angle = 1.5}));
}

TEST(ThisCourseInWebAssembly, HasAClockOfItsOwn) {
  if (engines_in_webassembly().empty()) GTEST_SKIP();
  const Scene<SpaceBody> scene = pyramid<SpaceBody>(4);
  const auto one = contestant<SpaceBody>(engines_in_webassembly().front(), {});
  const double seconds = seconds_a_frame<SpaceBody>({}, {one}, scene, 30, 1).front().least;
  EXPECT_GT(seconds, 1e-6);
  EXPECT_LT(seconds, 1);
}

TEST(Engines, EachIsTriedWithTheSameStepsAndIterations) {
  std::vector<Engine> all = everybody();
  all.push_back(this_course());
  const auto tried = [](const std::vector<Setting>& settings, const auto& number) {
    std::set<double> numbers;
    for (const Setting& setting : settings)
      if (setting.row == Row::tuned && setting.knobs.value("DANTZIG", 0) == 0) numbers.insert(number(setting));
    return numbers;
  };
  const auto steps = [](const Setting& setting) { return setting.steps * setting.knobs.value("substeps", 1); };
  const auto set = [](const auto& numbers) { return std::set<double>(numbers.begin(), numbers.end()); };
  // All of these iterations a frame, and none that no share comes to: of 32 in 3 steps, 30.
  const auto as_shared = [](const std::set<double>& numbers, const std::set<double>& least,
                            const std::vector<Shares>& shares) {
    std::set<double> shared;
    for (const Shares& one : shares) shared.insert(one.steps * one.iterations);
    return std::ranges::includes(numbers, least) && std::ranges::includes(shared, numbers);
  };
  for (const Engine& engine : all) {
    const auto joints = tried(engine.settings.joints, iterations_a_frame),
               contacts = tried(engine.settings.contacts, iterations_a_frame);
    if (engine.name == "Box2D 3" || engine.name == "Box3D") {  // a substep is an iteration
      EXPECT_EQ(joints, set(substeps_of_joints)) << engine.name;
      EXPECT_EQ(contacts, set(substeps_of_contacts)) << engine.name;
      continue;
    }
    EXPECT_EQ(tried(engine.settings.joints, steps), set(joint_steps)) << engine.name;
    EXPECT_EQ(tried(engine.settings.contacts, steps), set(contact_steps)) << engine.name;
    EXPECT_TRUE(joints == set(joint_steps) || as_shared(joints, set(joint_iterations), shares_of_joints()))
        << engine.name;
    EXPECT_TRUE(contacts == set(contact_steps) ||
                as_shared(contacts, set(contact_iterations), shares_of_contacts()))
        << engine.name;
  }
}

TEST(Contest, RunsForAsLongAsItsLookSays) {
  std::vector<double> times;
  run_while<M>({}, contestant<M>(this_course(), {}), stack(1), 10, [&](const Scene<M>&, double time) {
    times.push_back(time);
    return times.size() < 3;
  });
  EXPECT_EQ(times, (std::vector<double>{1 * frame, 2 * frame, 3 * frame}));
}

// Where numbers overflow, ODE's checks end the program.
TEST(Engines, OdeIsNotSteppedOnceItHasExploded) {
  Scene<M> scene = box_on_incline(0.3, 0.4);
  scene.state().velocity[1] = {1e200, 1e200, 1e200};
  for (const Engine& engine : all_engines()) {
    if (!engine.name.starts_with("ODE")) continue;
    int frames = 0;
    run<M>(contestant<M>(engine, {}), scene, 3, [&](const Scene<M>&, double) { ++frames; });
    EXPECT_EQ(frames, 3) << engine.name;
  }
}

// MuJoCo would begin anew, as if nothing had happened.
TEST(Engines, MujocoTellsThatItHasExploded) {
  Scene<M> scene = box_on_incline(0.3, 0.4);
  scene.state().velocity[1] = {1e200, 1e200, 1e200};
  for (const Engine& engine : everybody()) {
    if (!engine.name.starts_with("MuJoCo")) continue;
    const Eigen::Vector2d began = scene.bodies().pose[1].position;
    run<M>(contestant<M>(engine, {}), scene, 3, [&](const Scene<M>& seen, double) {
      EXPECT_FALSE((seen.bodies().pose[1].position - began).norm() < 1e3) << engine.name;
    });
  }
}

TEST(Contest, IsAheadOnlyByMoreThanATenthOfTheTime) {
  const std::vector<Point> ours{{{1, 1.2}, 1e-2}, {{10, 12}, 1e-4}};
  const auto rank = [&](const Point& point) { return at_equal_time({point}, ours).rank; };
  EXPECT_EQ(rank({{11, 12}, 1e-3}), Rank::behind) << "slower, and more error";
  EXPECT_EQ(rank({{11, 12}, 1e-4}), Rank::behind) << "slower, and the same error";
  EXPECT_EQ(rank({{11, 12}, 0.995e-4}), Rank::behind) << "the same error within a hundredth";
  EXPECT_EQ(rank({{11, 12}, 1e-5}), Rank::ahead) << "no point of ours has so little";
  EXPECT_EQ(rank({{9.9, 10.1}, 1e-4}), Rank::level) << "ours may be as fast";
  EXPECT_EQ(rank({{8, 30}, 1e-4}), Rank::ahead) << "a slow round is the machine's";
  EXPECT_EQ(at_equal_time({{{9.9, 10.1}, 1e-4}, {{8, 9}, 1e-4}}, ours).point.seconds.least, 8);
  EXPECT_EQ(at_equal_time({}, ours).rank, Rank::behind);
}

TEST(Contest, ComparesErrorsAtATimeWithinWhichBothHaveARun) {
  const std::vector<Point> ours{{{1, 1.2}, 1e-2}, {{10, 12}, 1e-4}};
  const Point quick{{0.5, 0.9}, 1e-1}, no_slower{{0.9, 1.1}, 1e-3}, good{{4, 5}, 1e-3};
  const auto beside = [&](const std::vector<Point>& points) { return at_equal_time(points, ours); };
  EXPECT_EQ(beside({quick}).rank, Rank::behind) << "each of ours has a smaller error";
  EXPECT_EQ(beside({quick}).quicker->seconds.least, 0.5) << "but none is as fast";
  const Point as_good{{9.9, 10.1}, 1e-4};
  EXPECT_EQ(beside({quick, as_good}).rank, Rank::level);
  EXPECT_EQ(beside({quick, as_good}).quicker->seconds.least, 0.5);
  EXPECT_EQ(beside({{{0.5, 0.9}, 1e-3}}).rank, Rank::ahead) << "quicker than ours with more error";
  EXPECT_EQ(beside({no_slower}).rank, Rank::ahead) << "ours may be as fast";
  EXPECT_EQ(beside({{{0.95, 1.1}, 1}}).rank, Rank::behind);
  EXPECT_FALSE(beside({{{0.95, 1.1}, 1}}).quicker) << "nor is it quicker: times within a tenth are equal";
  EXPECT_TRUE(beside({{{0.9, 1.5}, 1}}).quicker) << "a slow round is the machine's";
  EXPECT_EQ(beside({quick, good}).rank, Rank::ahead);
  EXPECT_EQ(beside({quick, good}).point.seconds.least, 4) << "and from there on";
  EXPECT_EQ(at_equal_time(ours, {quick}).rank, Rank::ahead) << "the same from the other side";
  EXPECT_EQ(at_equal_time(ours, {good}).rank, Rank::ahead) << "with its slower run, at a time of both";
  EXPECT_EQ(at_equal_time(ours, {good}).point.seconds.least, 10);
  EXPECT_TRUE(at_equal_time({good}, {}).quicker) << "of none there is no error to compare";
}

TEST(Knobs, KeepWhatIsNotTurned) {
  const Knobs knobs{{"iterations", 40}, {"ERP", 0.8}};
  int iterations = 10;
  double erp = 0.2, cfm = 1e-5;
  knobs.turn("iterations", iterations);
  knobs.turn("ERP", erp);
  knobs.turn("CFM", cfm);
  EXPECT_EQ(iterations, 40);
  EXPECT_EQ(erp, 0.8);
  EXPECT_EQ(cfm, 1e-5);
  EXPECT_EQ(knobs.words(), "40 iterations, ERP 0.8");
  EXPECT_EQ(Knobs({{"RK4", 1}, {"NNCG", 0}, {"substeps", 1}, {"CFM", 0.1}}).words(), "RK4, 1 substep, CFM 0.1");
  EXPECT_EQ(Knobs().words(), "as shipped");
}

}  // namespace adapters_test
}  // namespace byhand::engines
