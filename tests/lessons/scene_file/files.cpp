// Scenes as files: what is written reads back to the same bits, and every refusal names its place.

#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <filesystem>
#include <fstream>
#include <random>
#include <sstream>

#include "lessons/catalogue/catalogue.hpp"
#include "lessons/scenes/pull.hpp"
#include "tests/lessons/scene_file/course_scenes.hpp"

namespace byhand::test {
namespace {

using testing::AllOf;
using testing::HasSubstr;

const std::filesystem::path scenes = std::filesystem::path(BYHAND_SOURCE) / "lessons" / "scenes";

std::string text_of_file(const std::filesystem::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

/// All poses and velocities after some steps, or at the first step without an answer, as bytes.
std::string bits(const SceneOfAnyModel& any, const VelocityStepping& method, int steps = 90) {
  return std::visit(
      [&]<class M>(const Scene<M>& scene) {
        Simulation<M> simulation{scene, method};
        std::string bytes;
        try {
          for (int i = 0; i < steps; ++i) simulation.step(1.0 / 60);
        } catch (const std::runtime_error& error) {
          bytes = error.what();
        }
        const auto add = [&](const auto& numbers) {
          for (const double x : numbers) bytes.append(reinterpret_cast<const char*>(&x), sizeof x);
        };
        const Bodies<M>& bodies = simulation.scene.bodies();
        for (int i = 0; i < bodies.size(); ++i) {
          add(bodies.pose[i].position);
          add(bodies.velocity[i]);
          if constexpr (M::angular == 1)
            add(Packed<double, 2>(bodies.pose[i].rotation.cos, bodies.pose[i].rotation.sin));
          if constexpr (M::angular == 3) add(bodies.pose[i].rotation.coeffs());
        }
        return bytes;
      },
      any);
}

std::string refusal(const std::string& text) {
  try {
    read_scene(text);
  } catch (const std::invalid_argument& bad) {
    return bad.what();
  }
  return "";
}

class CourseScenes : public testing::TestWithParam<int> {
 protected:
  const CourseScene& scene() const { return course_scenes()[static_cast<std::size_t>(GetParam())]; }
};
TEST_P(CourseScenes, StepToTheSameBitsFromTheirFiles) {
  const std::string text = text_of_file(scenes / (scene().name + ".json"));
  ASSERT_FALSE(text.empty()) << scene().name << ".json is missing: write_scenes makes it";
  const SceneFile file = read_scene(text);
  EXPECT_EQ(bits(file.scene, file.method), bits(scene().make(), scene().method)) << scene().name;
  EXPECT_EQ(write_scene(file), text) << scene().name;
}
INSTANTIATE_TEST_SUITE_P(All, CourseScenes, testing::Range(0, static_cast<int>(course_scenes().size())),
                         [](const auto& scene) {
                           return course_scenes()[static_cast<std::size_t>(scene.param)].name;
                         });

TEST(SceneFiles, AreAllOfTheCourse) {
  std::set<std::string> files, known;
  for (const auto& entry : std::filesystem::directory_iterator(scenes))
    if (entry.path().extension() == ".json") files.insert(entry.path().stem().string());
  for (const CourseScene& scene : course_scenes()) known.insert(scene.name);
  EXPECT_EQ(files, known);
  for (const NamedScene& named : catalogue()) EXPECT_EQ(known.count(named.name), 1U) << named.name;
}

TEST(SceneFiles, AreTheChoosersScenes) {
  for (const NamedScene& named : catalogue()) {
    const SceneFile file = read_scene(text_of_file(scenes / (named.name + ".json")));
    AnyScene from_file = std::visit([](const auto&scene) { return AnyScene(scene); }, file.scene),
             from_code = Problem(named.name, {}, named.name == "chain" ? "links in the plane" : "").start();
    for (int i = 0; i < 60; ++i) {
      from_file.step(1.0 / 60);
      from_code.step(1.0 / 60);
    }
    const auto one = from_file.placements(), other = from_code.placements();
    ASSERT_EQ(one.size(), other.size()) << named.name;
    for (std::size_t i = 0; i < one.size(); ++i) {
      EXPECT_EQ(one[i].position, other[i].position) << named.name << ", body " << i;
      EXPECT_EQ(one[i].rotation, other[i].rotation) << named.name << ", body " << i;
    }
  }
}

TEST(SceneFiles, HaveTheSchemaThatIsPublished) {
  EXPECT_EQ(scene_schema(),
            text_of_file(std::filesystem::path(BYHAND_SOURCE) / "lessons" / "scene_file" / "scene.schema.json"));
}

/// A scene with every kind of its model, in which all members differ from what they are without being named.
template <class M>
Scene<M> every_kind() {
  Scene<M> scene;
  scene.gravity = Linear<M>::Constant(-1.25);
  const int ground = scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>());
  std::vector<int> bodies;
  for (int i = 1; i <= 4; ++i) {
    Pose<M> pose;
    pose.position = i * Linear<M>::Unit(0) + 0.1 * i * i * Linear<M>::Unit(1);
    InverseMass<M> mass;
    mass.linear = 1 / (1.1 * i);
    if constexpr (M::angular == 1) {
      pose.rotation = rotated_by(plane_rotation(0.3 * i), 1e-3);
      mass = with_mass<M>(1.1 * i, Angular<M>(0.7 * i));
    }
    if constexpr (M::angular == 3) {
      pose.rotation = space_rotation(Packed<double, 3>(0.3 * i, -0.1, 0.2));
      mass = with_mass<M>(1.1 * i, Angular<M>(0.7 * i, 0.8 * i, 0.9 * i));
    }
    bodies.push_back(scene.add_body(pose, mass, Velocity<M>::Constant(0.01 * i)));
  }
  const auto& all = scene.bodies();
  const auto at = [&](int i) { return Linear<M>(0.5 * i * Linear<M>::Ones()); };
  scene.add(Distance<M>{between<M>(all, ground, at(0), bodies[0], at(1)), 1.2, 0.001});
  scene.add(NormalisedDistance<M>{between<M>(all, bodies[0], at(1), bodies[1], at(2)), 0.9, 0.002});
  scene.add(Rope<M>{between<M>(all, bodies[1], at(1), bodies[2], at(3)), 4, 0.003});
  scene.add(Spring<M>{between<M>(all, bodies[2], at(2), bodies[3], at(4)), 1.5, {40, 0.5}});
  scene.add(Pin<M>{between<M>(all, ground, at(2), bodies[3], at(2)), 0.004});
  const auto contact =
      scene.add(Contact<M>{between<M>(all, ground, at(0), bodies[2], at(0)), Linear<M>::Unit(1), 0.005, 0.25});
  Friction<M> slip;
  slip.at = between<M>(all, ground, at(0), bodies[2], at(0));
  slip.tangents = tangents_of<M>(Linear<M>::Unit(1));
  slip.coefficient = 0.3, slip.contact = contact;
  scene.add(slip);
  if constexpr (M::angular > 0) {
    scene.add(weld<M>(all, bodies[0], bodies[2], at(1)));
    scene.add(slider<M>(all, bodies[0], bodies[3], at(1), Linear<M>::Ones()));
    const Slide<M> way = slide<M>(all, bodies[1], bodies[3], at(1), Linear<M>::Ones());
    scene.add(at_most<M>(2.5, way));
    scene.add(motor<M>(way, 0.4, 10));
    scene.add(servo<M>(way, 0.1, {30, 2}, INFINITY));
    Turn<M> angle;
    if constexpr (M::angular == 1)
      angle = turn<M>(all, bodies[1], bodies[2]);
    else
      angle = turn<M>(all, bodies[1], bodies[2], Linear<M>::Ones());
    scene.add(at_least<M>(-1.1, angle));
    scene.add(motor<M>(angle, 0.2, 3));
    scene.add(servo<M>(angle, 0.3, {5, 1}, 7));
    scene.set_shape(ground, HalfSpace<M>{Linear<M>::Unit(1)}, {0.7, 0.1});
    scene.set_shape(bodies[0], Ball<M>{0.4}, {0.2, 0.3}, {2, 5});
    scene.set_shape(bodies[1], Box<M>{Linear<M>::Constant(0.5)});
    scene.set_margin(0.03, 0.5);
    scene.set_damping(bodies[1], 0.1, 0.2);
    scene.set_gravity_scale(bodies[2], -0.5);
  }
  if constexpr (M::angular == 3) {
    scene.add(hinge<M>(all, bodies[0], bodies[1], at(1), Linear<M>::Ones()));
    scene.add(at_most<M>(0.9, swing<M>(all, bodies[2], bodies[3], Linear<M>::Unit(2))));
    AxisFriction<M> axis;
    axis.at = between<M>(all, ground, at(0), bodies[2], at(0));
    axis.tangents = Linear<M>::Unit(0), axis.coefficient = 0.2, axis.contact = contact;
    scene.add(axis);
  }
  if constexpr (M::angular == 1) {
    scene.set_contact_rows(ContactRows::points);
    ContactManifold<M> face;
    face.at = between<M>(all, ground, at(0), bodies[3], at(0));
    face.second = between<M>(all, ground, at(1), bodies[3], at(1)).arms;
    face.coefficient = 0.4, face.restitution = 0.2, face.softness = 0.01;
    scene.add(face);
  }
  return scene;
}

template <class M>
class EveryKind : public testing::Test {};
using Models = testing::Types<PlaneParticle, PlaneBody, SpaceParticle, SpaceBody>;
TYPED_TEST_SUITE(EveryKind, Models);
TYPED_TEST(EveryKind, StepsToTheSameBitsOnceReadBack) {
  SceneFile file;
  file.scene = every_kind<TypeParam>();
  file.method = {GaussSeidel{.sweeps = 7, .warm_start = false, .order = SweepOrder::reverse},
                 SplitImpulse{.beta = 0.3, .slop = 0.002}, 2};
  const std::string text = write_scene(file);
  const SceneFile back = read_scene(text);
  EXPECT_EQ(write_scene(back), text);
  EXPECT_EQ(bits(back.scene, back.method), bits(file.scene, file.method)) << text;
  std::visit(
      [&](const auto& scene) {
        std::set<std::string> kinds;
        for (const auto& entry : scene.entries()) kinds.insert(scene.store(entry.kind).kind().name());
        std::visit([&](const auto& original) { EXPECT_EQ(scene.count(), original.count()); }, file.scene);
        EXPECT_GE(kinds.size(), 7U);
      },
      back.scene);
}

TEST(SceneFiles, KeepMassesWhoseInverseNoMassHas) {
  std::mt19937_64 bits_of(1);
  for (int i = 0; i < 2000; ++i) {
    Scene<PlaneBody> scene;
    const double inverse =
        std::ldexp(1 + static_cast<double>(bits_of() >> 12) * 0x1p-52, static_cast<int>(bits_of() % 20) - 10);
    scene.add_body({0, 0}, InverseMass<PlaneBody>{inverse, Angular<PlaneBody>(1.3 * inverse)});
    SceneFile file;
    file.scene = scene;
    const SceneFile back = read_scene(write_scene(file));
    const auto& mass = std::get<Scene<PlaneBody>>(back.scene).bodies().inverse_mass[0];
    ASSERT_EQ(mass.linear, inverse);
    ASSERT_EQ(mass.angular[0], 1.3 * inverse);
  }
}

TEST(SceneFiles, AreNotWrittenForKindsOfAProgramsOwn) {
  Scene<PlaneBody> scene;
  scene.add_body({0, 0}, fixed<PlaneBody>());
  scene.add_body({1, 0}, box<PlaneBody>(1, {1, 1}));
  Pull<PlaneBody> hand;
  hand.at.body2 = 1, hand.strength = 1, hand.elastic = {1, 1};
  scene.add(hand);
  SceneFile file;
  file.scene = scene;
  EXPECT_THROW(write_scene(file), std::invalid_argument);
}

TEST(SceneFiles, MayBeWrittenAsPeopleDo) {
  const SceneFile file = read_scene(R"({
    // A comment.
    "model": "space", /* and
    another */ "gravity": [0, -1.62, 0],
    "bodies": [
      {"name": "ground", "fixed": true},
      {"name": "door", "mass": 10, "shape": {"box": [1, 2, 0.1]}, "position": [0.5, 1, 0], "angle": [0, "90°", 0], "spin": [0, "180°", 0]}
    ],
    "constraints": [
      {"kind": "hinge", "bodies": ["ground", "door"], "point": [0, 1, 0], "axis": [0, 2, 0]},
      {"kind": "limit", "on": "turn", "bodies": ["ground", 1], "axis": [0, 1, 0], "at_most": "120°"},
      {"kind": "motor", "on": "turn", "bodies": [0, 1], "axis": [0, 1, 0], "speed": 1, "strength": "infinite"}
    ],
    "accuracy": {"drift": 1e-3}
  })");
  const auto& scene = std::get<Scene<SpaceBody>>(file.scene);
  EXPECT_EQ(file.name_of(1), "\"door\"");
  EXPECT_EQ(file.name_of(7), "body 7");
  EXPECT_EQ(file.accuracy.at("drift"), 1e-3);
  EXPECT_EQ(scene.all<Hinge>().size(), 1U);
  EXPECT_DOUBLE_EQ(scene.bodies().velocity[1][4], 3.14159265358979323846);
  const auto built =
      hinge<SpaceBody>(scene.bodies(), 0, 1, Linear<SpaceBody>(0, 1, 0), Linear<SpaceBody>(0, 2, 0));
  EXPECT_EQ(scene.all<Hinge>()[0].across, built.across);
  EXPECT_EQ(scene.all<Hinge>()[0].at.arms.second, built.at.arms.second);
  EXPECT_EQ((scene.all<Motor<SpaceBody, Turn>>()[0].strength), INFINITY);
}

TEST(SceneFiles, AreRefusedWithLineMemberValueAndWhatIsAllowed) {
  const std::string head =
      "{\n\"model\": \"plane\",\n\"bodies\": [\n{\"fixed\": true},\n{\"mass\": 1, \"inertia\": [1], \"position\": "
      "[1, 0]}\n]";
  const auto with = [&](const std::string& more) { return refusal(head + ",\n" + more + "\n}"); };
  EXPECT_EQ(refusal(head + "}"), "");
  EXPECT_THAT(with("\"step\": 2"),
              AllOf(HasSubstr("line 7: step is 2"), HasSubstr("at most 1"), HasSubstr("[s]")));
  EXPECT_THAT(with("\"stop\": 2"), AllOf(HasSubstr("line 7"), HasSubstr("\"stop\""), HasSubstr("step")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"pin\", \"bodies\": [0, 2]}]"),
              AllOf(HasSubstr("line 8: constraints[0].bodies[1] is 2"), HasSubstr("from 0 to 1")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"pin\", \"bodies\": [\"door\", 1]}]"),
              AllOf(HasSubstr("line 8"), HasSubstr("\"door\""), HasSubstr("name of a body")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"pun\", \"bodies\": [0, 1]}]"),
              AllOf(HasSubstr("line 8: constraints[0].kind is \"pun\""), HasSubstr("\"pin\"")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"distance\", \"bodies\": [0, 1],\n \"length\": -1}]"),
              AllOf(HasSubstr("line 9: constraints[0].length is -1"), HasSubstr("above 0"), HasSubstr("[m]")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"pin\", \"bodies\": [1, 1]}]"),
              AllOf(HasSubstr("line 8: constraints[0]"), HasSubstr("body index is 1")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"limit\", \"on\": \"turn\", \"bodies\": [0, 1], \"at_most\": "
                   "\"30 degrees\"}]"),
              AllOf(HasSubstr("line 8"), HasSubstr("30 degrees"), HasSubstr("30°")));
  EXPECT_THAT(with("\"constraints\": [\n{\"kind\": \"spring\", \"bodies\": [0, 1]}]"),
              AllOf(HasSubstr("line 8"), HasSubstr("stiffness")));
  EXPECT_THAT(with("\"method\": {\"solver\": \"gauss_seidel\", \"sweeps\": 2.5}"),
              AllOf(HasSubstr("sweeps is 2.5"), HasSubstr("whole")));
  EXPECT_THAT(with("\"method\": {\"cure\": \"baumgarte\", \"beta\": 4}"),
              AllOf(HasSubstr("method.beta is 4"), HasSubstr("3")));
  EXPECT_THAT(with("\"gravity\": [0, -9.81, 0]"),
              AllOf(HasSubstr("gravity is a list of 3"), HasSubstr("list of 2")));
  EXPECT_THAT(with("\"title\": 3"), AllOf(HasSubstr("title is 3"), HasSubstr("text")));
  EXPECT_THAT(with("\"title\": \"a\",\n\"title\": \"b\""), AllOf(HasSubstr("line 8"), HasSubstr("twice")));
  EXPECT_THAT(with("\"duration\": 3600, \"step\": 1e-6"), HasSubstr("1000000"));
  EXPECT_THAT(refusal("{\n\"model\": \"plane\",\n\"bodies\": [{\"mass\": 1}]}"),
              AllOf(HasSubstr("line 3"), HasSubstr("inertia")));
  EXPECT_THAT(refusal("{\n\"model\": \"plane\",\n\"bodies\": [{}]}"),
              AllOf(HasSubstr("line 3"), HasSubstr("fixed")));
  EXPECT_THAT(refusal("{\n\"model\": \"plane\",\n\"bodies\": [{\"mass\": 1, \"shape\": {\"box\": [1, 0]}}]}"),
              AllOf(HasSubstr("line 3: bodies[0].shape.box[1] is 0"), HasSubstr("above 0")));
  EXPECT_THAT(refusal("{\n\"model\": \"plane\",\n\"bodies\": []}"), HasSubstr("at least one body"));
  EXPECT_THAT(refusal("{\n\"model\": \"solid\"}"),
              AllOf(HasSubstr("line 2"), HasSubstr("\"solid\""), HasSubstr("\"space\"")));
  EXPECT_THAT(refusal("{\n\"model\": \"plane\",,\n"), AllOf(HasSubstr("line 2"), HasSubstr("not JSON")));
  EXPECT_THAT(refusal(""), HasSubstr("not JSON"));
  EXPECT_THAT(refusal("[1]"), HasSubstr("an object"));
  EXPECT_THAT(refusal(std::string(100, '[')), HasSubstr("16"));
  EXPECT_THAT(refusal("{\"model\": \"plane\", \"bodies\": [{\"fixed\": true, \"position\": [1e999, 0]}]}"),
              HasSubstr("line 1"));
}

/// A text with some of its bytes changed, left out, doubled, or pieces of others put in.
std::string mutated(std::string text, std::mt19937_64& bits) {
  const auto any = [&](std::size_t below) { return static_cast<std::size_t>(bits() % below); };
  static const std::vector<std::string> pieces{"0",       "-1",          "1e308",      "-1e-308",
                                               "null",    "true",        "[]",         "{}",
                                               "\"\"",    "\"30°\"",     ",",          ":",
                                               "[",       "}",           "\"bodies\"", "\"kind\"",
                                               "\"pin\"", "\"contact\"", "\"point\"",  "99999999999999999999",
                                               "0.5",     "2",           "\xff",       "//",
                                               "/*",      "\n"};
  for (std::size_t count = 1 + any(4); count > 0 && !text.empty(); --count) {
    const std::size_t place = any(text.size()), length = 1 + any(12);
    switch (any(6)) {
      case 0: text[place] = static_cast<char>(bits()); break;
      case 1: text.erase(place, length); break;
      case 2: text.insert(place, text.substr(any(text.size()), length)); break;
      case 3: text.insert(place, pieces[any(pieces.size())]); break;
      case 4: {  // another number for a number
        const std::size_t digit = text.find_first_of("0123456789", place);
        if (digit == std::string::npos) break;
        std::size_t end = text.find_first_not_of("0123456789.e-", digit);
        text.replace(digit, (end == std::string::npos ? text.size() : end) - digit, pieces[any(10)]);
        break;
      }
      default: {  // one word for another
        const std::size_t quote = text.find('"', place), from = text.find('"', any(text.size()));
        if (quote == std::string::npos || from == std::string::npos) break;
        const std::size_t end = text.find('"', quote + 1), until = text.find('"', from + 1);
        if (end == std::string::npos || until == std::string::npos) break;
        text.replace(quote, end - quote, text.substr(from, until - from));
      }
    }
  }
  return text;
}

TEST(SceneFiles, NeverCrashTheReaderOrAStep) {
  std::vector<std::string> texts;
  for (const char* name :
       {"slider_crank", "ragdoll", "heavy_on_light_in_space", "box_on_contacts", "spherical_pendulum"})
    texts.push_back(text_of_file(scenes / (std::string(name) + ".json")));
  SceneFile all;
  all.scene = every_kind<SpaceBody>();
  texts.push_back(write_scene(all));
  all.scene = every_kind<PlaneBody>();
  texts.push_back(write_scene(all));
  const char* asked = std::getenv("BYHAND_MUTATED_FILES");
  const int count = asked ? std::atoi(asked) : 5000;
  std::mt19937_64 bits_of(20261124);
  int read = 0;
  for (int i = 0; i < count; ++i) {
    const std::string text = mutated(texts[static_cast<std::size_t>(i) % texts.size()], bits_of);
    try {
      SceneFile file = read_scene(text);
      ++read;
      const SceneFile back = read_scene(write_scene(file));
      ASSERT_EQ(bits(back.scene, back.method, 2), bits(file.scene, file.method, 2)) << text;
    } catch (const std::invalid_argument& bad) {
      ASSERT_FALSE(std::string(bad.what()).empty());
    }
  }
  EXPECT_GT(read, count / 50) << "of " << count << " files that were read";
}

}  // namespace
}  // namespace byhand::test
