// Scenes from files as problems of the chooser.

#include "lessons/stage/request.hpp"

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <fstream>
#include <set>
#include <sstream>

namespace byhand::stage {
namespace {

using testing::HasSubstr;

SceneFile course_scene(const std::string& name) {
  std::ifstream stream(std::string(BYHAND_SOURCE) + "/lessons/scenes/" + name + ".json");
  std::ostringstream text;
  text << stream.rdbuf();
  return read_scene(text.str());
}
AnyScene any(const SceneFile& file) {
  return std::visit([](const auto& scene) { return AnyScene(scene); }, file.scene);
}
void expect_same(const AnyScene& one, const AnyScene& other, const std::string& name) {
  const auto places = one.placements(), others = other.placements();
  ASSERT_EQ(places.size(), others.size()) << name;
  for (std::size_t i = 0; i < places.size(); ++i) {
    EXPECT_EQ(places[i].position, others[i].position) << name;
    EXPECT_EQ(places[i].rotation, others[i].rotation) << name;
    EXPECT_EQ(places[i].moves, others[i].moves) << name;
  }
  EXPECT_EQ(one.momentum(), other.momentum()) << name;
}

TEST(Catalogue, HasAFileOfTheSameBitsForEachScene) {
  for (const NamedScene& named : catalogue()) {
    AnyScene from_file = any(course_scene(named.name)), from_name = Problem(named.name).start();
    expect_same(from_file, from_name, named.name);
    const AnyStepping method{GaussSeidel{}, Baumgarte{}};
    from_file.use(method), from_name.use(method);
    for (int i = 0; i < 30; ++i) from_file.step(frame), from_name.step(frame);
    expect_same(from_file, from_name, named.name);
  }
}

// The references of files are runs; those of the catalogue are closed forms and integrations in angles.
TEST(Request, KnowsTheTrueMotion) {
  for (const char* name : {"pendulum", "compound_pendulum", "double_pendulum", "four_bar", "spherical_pendulum",
                           "conical_pendulum", "top", "stack", "incline"}) {
    const Problem of_file = request_of(course_scene(name)).problem, of_name(name);
    const double time = 30 * frame;
    const ExactState found = of_file.scene().exact(of_file)(time), exact = of_name.scene().exact(of_name)(time);
    ASSERT_EQ(found.positions.size(), exact.positions.size()) << name;
    EXPECT_LT(found.uncertainty, 2e-3) << name;
    for (std::size_t i = 0; i < found.positions.size(); ++i)
      EXPECT_LE((found.positions[i] - exact.positions[i]).norm(), 1.5 * found.uncertainty + 1e-9) << name;
  }
}

/// A bob of 1 kg that hangs on a spring that is stretched by 10 cm, of so much damping [N s/m] and stiffness
/// [N/m].
SceneFile bob_on_a_spring(double damping, int stiffness = 400) {
  SceneFile file = read_scene(R"({"model": "plane particles", "gravity": [0, -9.81], "step": 0.0166, "duration": 2,
      "bodies": [{"fixed": true, "position": [0, 0]}, {"mass": 1, "position": [0, -1.1]}],
      "constraints": [{"kind": "spring", "bodies": [0, 1], "length": 1, "stiffness": )" +
                              std::to_string(stiffness) + R"(, "damping": )" + std::to_string(damping) + "}]}");
  file.accuracy = {{"energy", 0.01}, {"trajectory", 1e-4}};
  return file;
}

// Steps of first order, extrapolated: y = -1 - g/ω² - (0.1 - g/ω²) e^-ζωt (cos ω't + ζω/ω' sin ω't).
TEST(Request, KnowsHowASpringSwings) {
  for (const double damping : {0.0, 2.0}) {
    const Request request = request_of(bob_on_a_spring(damping));
    const double sag = 9.81 / 400, decay = damping / 2, rate = std::sqrt(400 - decay * decay),
                 t = request.problem.compared_at();
    const double exact =
        -1 - sag - (0.1 - sag) * std::exp(-decay * t) * (std::cos(rate * t) + decay / rate * std::sin(rate * t));
    EXPECT_NEAR(t, 2, 1e-9) << damping;
    EXPECT_LT(request.problem.reference().uncertainty, 1e-5) << damping;
    EXPECT_NEAR(request.problem.reference().positions[0].y(), exact, 1e-5) << damping;
    EXPECT_TRUE(request.limits.contains(Error::trajectory)) << damping;
  }
}

// In 10 s runs of 8 to 512 substeps damp a spring of 30 kN/m to rest, and agree that it hangs still: not so within
// a second, and not if its own damper does.
TEST(Request, DoesNotBelieveThatAStiffSpringComesToRest) {
  const auto asked = [](double damping, double duration) {
    SceneFile file = bob_on_a_spring(damping, 30000);
    file.duration = duration;
    file.accuracy = {{"trajectory", 1e-3}};
    return request_of(file);
  };
  const Request request = asked(0, 10);
  ASSERT_FALSE(request.notes.empty());
  EXPECT_THAT(request.notes[0], HasSubstr("not known well enough"));
  EXPECT_NEAR(request.problem.compared_at(), 1, 1e-9);
  const double sag = 9.81 / 30000, exact = -1 - sag - (0.1 - sag) * std::cos(std::sqrt(30000.0));
  const Reference& known = request.problem.reference();
  EXPECT_LT(known.uncertainty, 0.01);
  EXPECT_NEAR(known.positions[0].y(), exact, known.uncertainty);
  const Request damped = asked(50, 10);
  EXPECT_NEAR(damped.problem.compared_at(), 10, 1e-9);
  EXPECT_NEAR(damped.problem.reference().positions[0].y(), -1 - sag, 1e-9);
}

// A chain that whips stops RATTLE with 8 substeps after 8 s, not with 32.
TEST(Request, WatchesAsLongAsShorterStepsGoOn) {
  std::string bodies, pins;
  for (int i = 1; i <= 20; ++i) {
    bodies += fmt::format(R"(, {{"mass": 1, "inertia": [0.0035], "position": [{}, 0]}})", 0.2 * i - 0.1);
    pins += fmt::format(R"({}{{"kind": "pin", "bodies": [{}, {}], "point": [{}, 0]}})", i > 1 ? ", " : "", i - 1,
                        i, 0.2 * (i - 1));
  }
  SceneFile file = read_scene(R"({"model": "plane", "bodies": [{"fixed": true, "position": [0, 0]})" + bodies +
                              R"(], "constraints": [)" + pins + "]}");
  file.duration = 12;
  file.accuracy = {{"drift", 1e-3}};
  const Request request = request_of(file);
  EXPECT_FALSE(request.broke);
  EXPECT_NEAR(request.seconds, 12, 1e-9);
}

// Springs ask for 199 and 300 substeps before an agreement is believed. Runs of 128 and 256 agree already, so that
// the next finer one decides.
TEST(Request, RefinesUntilSpringsAreResolved) {
  for (const double duration : {1.0, 1.5}) {
    SceneFile file = read_scene(R"({"model": "plane particles", "accuracy": {"trajectory": 0.005, "energy": 0.02},
        "bodies": [{"fixed": true, "position": [0, 0]}, {"mass": 1, "position": [0.5, 0]},
                   {"mass": 0.5, "position": [1, 0.1]}],
        "constraints": [{"kind": "spring", "bodies": [0, 1], "stiffness": 2000},
                        {"kind": "spring", "bodies": [1, 2], "stiffness": 8000}]})");
    file.duration = duration;
    const Request request = request_of(file);
    EXPECT_NEAR(request.problem.compared_at(), duration, 1e-9);
    EXPECT_TRUE(request.limits.contains(Error::trajectory)) << duration;
    for (const double gravity : {1.0, 1.02})
      EXPECT_LT(request.problem.with("gravity", gravity).reference().uncertainty, 1e-4) << duration;
  }
}

// y = -1 - g/ω² - (0.1 - g/ω²) cos ωt in the last tenth, and with critical damping next to nothing.
TEST(Request, KnowsHowFarTheTrueMotionGoesInItsLastTenth) {
  const double sag = 9.81 / 400;
  double most = 0;
  for (int frames = 1; frames <= 12; ++frames)
    most = std::max(most, (0.1 - sag) * std::abs(std::cos(20 * 2.0) - std::cos(20 * (2 - frames * frame))));
  EXPECT_NEAR(request_of(bob_on_a_spring(0)).last_motion, most, 0.1 * most);
  EXPECT_LT(request_of(bob_on_a_spring(40)).last_motion, 1e-6);
}

// A box of 3 × 12 cm tips about an edge: Iθ̈ = mgd sin θ about the corner, at d from the centre. A manifold's
// friction in the middle of both corners would let the edge slide as long as the other is near.
TEST(Request, KnowsHowABoxTipsAboutItsEdge) {
  const Request request = request_of(read_scene(R"({"model": "plane", "duration": 0.1,
    "accuracy": {"trajectory": 0.0005},
    "bodies": [{"fixed": true, "shape": {"half_space": [0, 1]}, "friction": 1},
               {"mass": 0.1, "shape": {"box": [0.03, 0.12]}, "angle": "-20°", "friction": 1,
                "position": [0.0064258192877514955, 0.061511859397039535]}]})"));
  const double d = std::hypot(0.015, 0.06), inertia = (0.03 * 0.03 + 0.12 * 0.12) / 12 + d * d;
  double angle = std::atan2(0.0064258192877514955, 0.061511859397039535), rate = 0;
  constexpr int parts = 100'000;
  for (int i = 0; i < parts; ++i) {  // leapfrog
    angle += 0.5 * request.problem.compared_at() / parts * rate;
    rate += request.problem.compared_at() / parts * 9.81 * d * std::sin(angle) / inertia;
    angle += 0.5 * request.problem.compared_at() / parts * rate;
  }
  const auto truth = request.problem.reference();
  EXPECT_NEAR(truth.positions[0].x(), d * std::sin(angle), 2e-5);
  EXPECT_NEAR(truth.positions[0].y(), d * std::cos(angle), 2e-5);
}

// Without weight and at rest it begins in one way only.
TEST(Request, VariesNothingWhereNothingCanVary) {
  const Request request = request_of(read_scene(R"({"model": "plane", "gravity": [0, 0], "duration": 1,
    "bodies": [{"fixed": true}, {"mass": 1, "inertia": [0.1], "position": [1, 0]}],
    "constraints": [{"kind": "pin", "bodies": [0, 1], "point": [0, 0]},
                    {"kind": "motor", "on": "turn", "bodies": [0, 1], "speed": 1, "strength": 5}]})"));
  EXPECT_TRUE(request.problem.scene().varied.empty());
}

// A direct solve of rows of several numbers a joint takes more than twice as much.
TEST(Request, PricesJointsOfSeveralKindsTogether) {
  const auto kind = [](const std::string& second) {
    return any(read_scene(R"({"model": "plane", "bodies": [{"fixed": true},
      {"mass": 1, "inertia": [0.1], "position": [1, 0]}, {"mass": 1, "inertia": [0.1], "position": [2, 0]}],
      "constraints": [{"kind": "pin", "bodies": [0, 1], "point": [0, 0]}, )" +
                          second + "]}"))
        .row_kind();
  };
  EXPECT_EQ(kind(R"({"kind": "pin", "bodies": [1, 2], "point": [1, 0]})"), "links");
  EXPECT_EQ(kind(R"({"kind": "spring", "bodies": [1, 2], "stiffness": 50})"), "mixed joints");
}

// A fine run of first order damps a spring. What keeps energy by its parts keeps it all the same.
TEST(Request, LimitsTheEnergyOfWhatTakesNone) {
  EXPECT_TRUE(request_of(bob_on_a_spring(0)).limits.contains(Error::energy));
  const Request damped = request_of(bob_on_a_spring(2));
  EXPECT_FALSE(damped.limits.contains(Error::energy));
  EXPECT_THAT(damped.notes.at(0), HasSubstr("dampers"));
}

// What moves and has weight starts with another speed and another weight, neither told by the other.
TEST(Request, VariesSpeedAndGravityOfWhatMoves) {
  const Problem thrown = request_of(course_scene("incline")).problem,
                hung = request_of(course_scene("chain")).problem;
  std::set<double> sums;
  for (int i = 1; i <= 20; ++i) {
    const double speed = thrown.variation(i)["speed"], gravity = thrown.variation(i)["gravity"];
    EXPECT_NEAR(speed, 1, 0.05);
    EXPECT_NEAR(gravity, 1, 0.05);
    sums.insert(std::round(1e6 * (speed - gravity)));
    EXPECT_EQ(hung.variation(i)["speed"], 1);
  }
  EXPECT_EQ(sums.size(), 20U);
}

// From another first speed a motor gives another energy than from the file's own.
TEST(Request, LetsAMotorGiveEnergyFromEachStart) {
  SceneFile file = course_scene("slider_crank");
  file.accuracy = {{"drift", 1e-3}};
  const Problem problem = request_of(file).problem;
  const Knobs knobs{.substeps = 4, .cure = Cure::baumgarte, .strength = 1};
  for (int i = 0; i < 8; ++i) {
    const Point run = measure(problem.variation(i), family_named("direct"), knobs);
    EXPECT_EQ(run.outcome, Outcome::good) << run.reason;
    EXPECT_LT(run[Error::drift], 1e-3);
  }
}

// (14) has a C in m²; a rod of 0.3 m that is 1 mm too long is 1 mm too long.
TEST(AnyScene, MeasuresTheDriftOfRodsInMetres) {
  for (const char* kind : {"distance", "normalised_distance"}) {
    const SceneFile file =
        read_scene(std::string(R"({"model": "plane particles", "gravity": [0, 0], "step": 0.01, "duration": 1,
        "bodies": [{"fixed": true, "position": [0, 0]}, {"mass": 1, "position": [0.301, 0]}],
        "constraints": [{"kind": ")") +
                   kind + R"(", "bodies": [0, 1], "length": 0.3}]})");
    EXPECT_NEAR(any(file).separation(), 1e-3, 1e-15) << kind;
  }
}

// A projectile costs what moving a body costs, by every method.
TEST(Request, PricesWhatNothingHolds) {
  const SceneFile file =
      read_scene(R"({"model": "plane particles", "gravity": [0, -9.81], "step": 0.0166, "duration": 1,
      "bodies": [{"mass": 1, "position": [0, 0], "velocity": [3, 8]}]})");
  const Problem problem = request_of(file).problem;
  for (const char* name : {"RATTLE", "direct", "Gauss–Seidel"})
    EXPECT_GT(measure(problem, family_named(name), {}).cost, 500) << name;
}

TEST(Request, TakesTheFilesAccuracy) {
  SceneFile file = course_scene("pendulum");
  file.accuracy = {{"drift", 1e-3}, {"energy", 0.01}, {"trajectory", 1e-4}};
  const Request request = request_of(file);
  EXPECT_TRUE(request.notes.empty());
  EXPECT_EQ(request.limits,
            (std::map<Error, double>{{Error::drift, 1e-3}, {Error::energy, 0.01}, {Error::trajectory, 1e-4}}));
}
TEST(Request, SaysWhichAccuracyTheSceneDoesNotHave) {
  SceneFile file = course_scene("incline");  // friction takes the energy
  file.accuracy = {{"energy", 0.01}, {"drift", 1e-3}};
  Request request = request_of(file);
  ASSERT_EQ(request.notes.size(), 1U);
  EXPECT_THAT(request.notes[0], HasSubstr("the true motion changes it by"));
  EXPECT_EQ(request.limits, (std::map<Error, double>{{Error::drift, 1e-3}}));
  file.accuracy = {{"momentum", 0.01}};
  request = request_of(file);
  EXPECT_EQ(request.notes.size(), 2U);
  EXPECT_EQ(request.limits, (std::map<Error, double>{{Error::drift, 0.01 * request.problem.size()}}));
}
TEST(Request, AsksWhatRestsToStayInItsPlace) {
  EXPECT_TRUE(request_of(course_scene("stack")).problem.scene().rests);
  EXPECT_FALSE(request_of(course_scene("dominoes")).problem.scene().rests);
}

// On both sides: a pendulum is known to its end, a pile is not.
TEST(Request, ComparesAtTheEndWhereTheMotionIsKnownSoFar) {
  SceneFile pendulum = course_scene("pendulum"), pile = course_scene("pile");
  pendulum.accuracy = pile.accuracy = {{"trajectory", 1e-3}};
  EXPECT_NEAR(request_of(pendulum).problem.compared_at(), pendulum.duration, 1e-9);
  EXPECT_NEAR(request_of(pile).problem.compared_at(), 1, 1e-9);
}

// Over-relaxed, one sweep throws a ball back as fast as it came, without any drift.
TEST(Chooser, FailsARunWhoseEnergyIsNotThatOfTheTrueMotion) {
  const Request request = request_of(course_scene("bouncing_ball"));
  const auto outcome = [&](double relaxation) {
    return measure(request.problem, family_named("Gauss–Seidel"),
                   {.passes = 1, .cure = Cure::projection, .strength = 1, .relaxation = relaxation})
        .outcome;
  };
  EXPECT_EQ(outcome(1.5), Outcome::strayed);
  EXPECT_EQ(outcome(1), Outcome::good);
}

// What nothing holds costs something all the same, and every method about the same.
TEST(Chooser, PricesAFreeBody) {
  const Request request = request_of(course_scene("thrown_book"));
  for (const char* name : {"AVBD", "RK4", "direct"}) {
    const Family& family = family_named(name);
    const double cost = measure(request.problem, family, with_cure({}, family.cures.front())).cost;
    EXPECT_GT(cost, 2000) << name;
    EXPECT_LT(cost, 8000) << name;
  }
}

TEST(Chooser, KeepsWhatAFileAsksFor) {
  SceneFile file = course_scene("heavy_on_light");
  file.accuracy = {{"drift", 1e-3}};
  const Request request = request_of(file);
  const Choice choice =
      choose(request.problem, {.limits = request.limits}, {.starts = 8, .enough = 5e8, .most = 2e9});
  ASSERT_TRUE(choice.reached);
  const Point again = measure(request.problem, *choice.best.point.family, choice.best.point.knobs);
  EXPECT_EQ(again.outcome, Outcome::good);
  EXPECT_LE(again[Error::drift], 1e-3);
  // Ten cold sweeps sink, as the first case tells.
  EXPECT_EQ(measure(request.problem, family_named("Jacobi"), {.passes = 4, .relaxation = 0.5}).outcome,
            Outcome::opened);
}
// The true motion of a block that slides takes as long as hundreds of runs.
TEST(Chooser, JudgesFromAllStartsWhatNeedsNoTrueMotion) {
  SceneFile file = course_scene("incline");
  file.accuracy = {{"drift", 0.05}, {"trajectory", 0.05}};
  const Request request = request_of(file);
  Search search{.starts = 30, .verification = 1.3 * *request.problem.scene().reference_work, .tighter = false};
  const Verification both = choose(request.problem, {.limits = request.limits}, search).verified;
  EXPECT_EQ(both.starts, 6);
  EXPECT_EQ(both.further, 24);
  EXPECT_TRUE(both.kept());
  EXPECT_THAT(further_in_words(both), HasSubstr("From 24 further starts"));
  auto limits = request.limits;
  limits.erase(Error::drift);
  EXPECT_EQ(choose(request.problem, {.limits = limits}, search).verified.further, 0);
  EXPECT_EQ(further_in_words({}), "");
}

// A contact's residual is that of its own rows: a stack is judged from all starts.
TEST(Chooser, NeedsNoTrueMotionForContacts) {
  SceneFile file = course_scene("stack");
  file.accuracy = {{"drift", 4e-3}, {"contact", 0.02}};
  const Request request = request_of(file);
  EXPECT_FALSE(asks_for_reference(request.limits));
  const Choice choice = choose(request.problem, {.limits = request.limits}, {.enough = 5e9, .most = 2e10});
  ASSERT_TRUE(choice.reached);
  EXPECT_EQ(choice.verified.starts, certain + 1);
  EXPECT_EQ(choice.verified.further, 0);
}

// What seems cheapest from few starts misses the limit from others, and what keeps it is several times as dear.
TEST(Chooser, LooksFurtherWhereWhatWasFoundMisses) {
  const SceneFile file = read_scene(R"({"model": "space", "duration": 2.5, "accuracy": {"trajectory": 0.05},
      "bodies": [{"fixed": true}, {"mass": 2, "inertia": [0.02, 0.2, 0.2], "position": [0.5, 0, 0]},
                 {"mass": 2, "inertia": [0.05, 0.05, 0.05], "position": [1.2, 0, 0]}],
      "constraints": [{"kind": "hinge", "bodies": [0, 1], "point": [0, 0, 0], "axis": [0, 0, 1]},
                      {"kind": "servo", "on": "turn", "axis": [0, 0, 1], "bodies": [0, 1], "target": 0.8,
                       "stiffness": 150, "damping": 12, "strength": 80},
                      {"kind": "pin", "bodies": [1, 2], "point": [1, 0, 0]}]})");
  const Request request = request_of(file);
  const double most = 6e10;
  const Choice choice =
      choose(request.problem, {.limits = request.limits},
             {.starts = 12, .verification = most / 10, .tighter = false, .enough = most, .most = most});
  ASSERT_TRUE(choice.reached);
  EXPECT_TRUE(choice.verified.kept());
  EXPECT_GT(choice.verified.starts, 6);
}

TEST(Request, SaysWhatFirstVelocitiesThatDoNotFitTakeOfTheEnergy) {
  const auto notes = [](const char* velocity) {
    return request_of(
               read_scene(fmt::format(
                   R"({{"model": "plane particles", "gravity": [0, 0], "duration": 2, "accuracy": {{"energy": 0.01}},
        "bodies": [{{"fixed": true}}, {{"mass": 1, "position": [1, 0], "velocity": {}}}],
        "constraints": [{{"kind": "distance", "bodies": [0, 1]}}]}})",
                   velocity)))
        .notes;
  };
  EXPECT_THAT(notes("[0, 1]"), testing::IsEmpty());
  // Of ½ (0.1² + 1²) J it takes ½ 0.1² J.
  EXPECT_THAT(notes("[0.1, 1]"), testing::ElementsAre(HasSubstr("takes 0.0099 of the energy")));
}

TEST(Chooser, EndsWithWhatItHas) {
  SceneFile file = course_scene("ragdoll");
  file.accuracy = {{"drift", 1e-12}};  // which nothing reaches
  const Request request = request_of(file);
  const Choice choice =
      choose(request.problem, {.limits = request.limits}, {.starts = 4, .enough = 2e8, .most = 5e8});
  EXPECT_FALSE(choice.reached);
  EXPECT_LT(choice.spent.work, 3e9);
  EXPECT_TRUE(choice.best.point.family);
}

}  // namespace
}  // namespace byhand::stage
