// ./lessons/run scene and ./lessons/run case, as a person types them.

#include <fmt/format.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include <sys/wait.h>

#include <array>
#include <cstdio>
#include <filesystem>
#include <fstream>
#include <sstream>
#include <string>

namespace {

namespace fs = std::filesystem;
using testing::ContainsRegex;
using testing::HasSubstr;
using testing::StartsWith;

struct Ran {
  int status = -1;
  std::string said;  // on standard output and standard error
};
Ran run(const std::string& command) {
  Ran ran;
  FILE* pipe = popen((command + " 2>&1 </dev/null").c_str(), "r");
  std::array<char, 4096> part;
  for (std::size_t count; (count = std::fread(part.data(), 1, part.size(), pipe)) > 0;)
    ran.said.append(part.data(), count);
  const int status = pclose(pipe);
  ran.status = WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  return ran;
}
std::string text_of(const fs::path& path) {
  std::ifstream stream(path);
  std::ostringstream text;
  text << stream.rdbuf();
  return text.str();
}

class SceneCommand : public testing::Test {
 protected:
  SceneCommand() : folder_(fs::path(testing::TempDir()) / ("byhand_scene_" + std::to_string(getpid()))) {
    fs::create_directories(folder_);
  }
  ~SceneCommand() override { fs::remove_all(folder_); }
  Ran scene(const std::string& words) const { return run(fmt::format("{} {}", BYHAND_SCENE, words)); }
  Ran scene_into(const std::string& words) const {
    return scene(words + " --output " + (folder_ / "out").string());
  }
  fs::path written(const std::string& text) const {
    const fs::path path = folder_ / "mine.json";
    std::ofstream(path) << text;
    return path;
  }

  fs::path folder_;
};

TEST_F(SceneCommand, RunsASceneOfTheCourseByItsName) {
  const Ran ran = scene_into("pendulum --frames none --quality low --set seconds=0.5");
  EXPECT_EQ(ran.status, 0) << ran.said;
  EXPECT_THAT(ran.said, HasSubstr("Simple pendulum"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "00_pendulum" / "lesson.md"));
  EXPECT_TRUE(fs::exists(folder_ / "out" / "00_pendulum" / "data" / "energy.csv"));
}
TEST_F(SceneCommand, RefusesAFileInOneSentenceAndWritesNothing) {
  const fs::path path = written("{\n\"model\": \"plane\",\n\"bodies\": [{\"mass\": -1}]\n}");
  const Ran ran = scene_into(path.string());
  EXPECT_EQ(ran.status, 2);
  EXPECT_THAT(ran.said, HasSubstr("mine.json, line 3: bodies[0].mass is -1, but it must be"));
  EXPECT_EQ(std::count(ran.said.begin(), ran.said.end(), '\n'), 1) << ran.said;
  EXPECT_FALSE(fs::exists(folder_ / "out"));
}
TEST_F(SceneCommand, RefusesWhatIsNoFile) {
  EXPECT_EQ(scene("").status, 2);
  EXPECT_THAT(scene("nowhere.json").said, HasSubstr("There is no file nowhere.json"));
  EXPECT_EQ(scene("nowhere.json").status, 2);
  EXPECT_EQ(scene(folder_.string()).status, 2);
  EXPECT_EQ(scene("/dev/zero").status, 2);
  EXPECT_EQ(scene_into("pendulum --method magic").status, 2);
  EXPECT_EQ(scene_into("pendulum --set seconds=3600 --set h=1e-6").status, 2);
}
TEST_F(SceneCommand, WritesWhatItHasRead) {
  const fs::path copy = folder_ / "copy.json";
  EXPECT_EQ(scene("ragdoll --write " + copy.string()).status, 0);
  EXPECT_EQ(text_of(copy), text_of(fs::path(BYHAND_SOURCE) / "lessons" / "scenes" / "ragdoll.json"));
}
TEST_F(SceneCommand, PrintsTheSchemaAndTheScenes) {
  EXPECT_EQ(scene("--schema").said,
            text_of(fs::path(BYHAND_SOURCE) / "lessons" / "scene_file" / "scene.schema.json"));
  EXPECT_THAT(scene("--list").said, HasSubstr("ragdoll"));
  EXPECT_THAT(scene("--help").said, StartsWith("./lessons/run scene FILE"));
}
TEST_F(SceneCommand, TakesItsHelpsExample) {
  const std::string help = scene("--help").said;
  const std::size_t from = help.find("  {\n"), to = help.find("\n  }\n");
  ASSERT_NE(from, std::string::npos);
  const Ran ran = scene_into(written(help.substr(from, to + 5 - from)).string() + " --check --set seconds=0.5");
  EXPECT_EQ(ran.status, 0) << ran.said;
}
TEST_F(SceneCommand, SaysWhichLawBreaksAScene) {
  const Ran ran = scene_into("heavy_chain --doctor --set solver=gauss_seidel --set sweeps=4");
  EXPECT_EQ(ran.status, 0) << ran.said;
  EXPECT_THAT(ran.said, HasSubstr("expects the scene to fail by law"));
  EXPECT_THAT(ran.said, HasSubstr("What to turn, in this order: "));
}
TEST_F(SceneCommand, ChoosesAMethodForWhatTheFileWantsAccurate) {
  std::string text = text_of(fs::path(BYHAND_SOURCE) / "lessons" / "scenes" / "pendulum.json");
  text.insert(text.find('{') + 1, "\n\"accuracy\": {\"trajectory\": 0.001, \"energy\": 0.01},");
  const Ran ran = scene_into(written(text).string() + " --choose");
  EXPECT_EQ(ran.status, 0) << ran.said;
  EXPECT_THAT(ran.said, ContainsRegex("with\\s+trajectory\\s+after\\s+10 s\\s+of\\s+at\\s+most\\s+0.001 "
                                      "m\\s+and\\s+energy\\s+of\\s+at\\s+most\\s+0.01"));
  EXPECT_THAT(ran.said, HasSubstr("ten times better"));
  EXPECT_THAT(ran.said, HasSubstr("Simulation simulation{scene, "));
  EXPECT_THAT(ran.said, Not(ContainsRegex("were\\s+not\\s+measured")));
  EXPECT_EQ(scene_into("pendulum --choose --doctor").status, 2);
}
TEST_F(SceneCommand, SaysWhichErrorsOfItsAnswerWereNotMeasuredAndGivesEachAnswerOnce) {
  std::string text = text_of(fs::path(BYHAND_SOURCE) / "lessons" / "scenes" / "pendulum.json");
  text.insert(text.find('{') + 1, "\n\"accuracy\": {\"drift\": 1},");
  const Ran ran = scene_into(written(text).string() + " --choose");
  EXPECT_THAT(ran.said, ContainsRegex("Its\\s+errors\\s+of\\s+trajectory\\s+and\\s+reaction\\s+were\\s+not"));
  EXPECT_THAT(ran.said, HasSubstr("C++, cheapest, robust, ten times better"));
}
// A link that moves at its centre, pinned to the world and to one at rest.
TEST_F(SceneCommand, SaysThatFirstVelocitiesTakeMoreEnergyThanALimitAllows) {
  const auto asked = [&](double energy) {
    return scene_into(
               written(fmt::format(R"({{"model": "plane", "duration": 3, "accuracy": {{"energy": {}}}, "bodies": [
        {{"fixed": true, "position": [0, 0]}},
        {{"mass": 1, "inertia": [0.1], "position": [0.5, 0], "velocity": [0, 1]}},
        {{"mass": 1, "inertia": [0.1], "position": [1.5, 0]}}], "constraints": [
        {{"kind": "pin", "bodies": [0, 1], "point": [0, 0]}}, {{"kind": "pin", "bodies": [1, 2], "point": [1, 0]}}]}})",
                                   energy))
                   .string() +
               " --choose")
        .said;
  };
  EXPECT_THAT(asked(0.001), ContainsRegex("No\\s+run\\s+of\\s+this\\s+file\\s+can\\s+keep\\s+that"));
  EXPECT_THAT(asked(0.05), ContainsRegex("so\\s+much\\s+of\\s+the\\s+limit\\s+of\\s+0.05\\s+is\\s+spent"));
}

TEST(CaseCommand, ListsTheCasesAndChecksOne) {
  EXPECT_THAT(run(BYHAND_CASE).said, HasSubstr("https://github.com/dartsim/dart/issues/3442"));
  const Ran ran = run(fmt::format("{} 3 --check", BYHAND_CASE));
  EXPECT_EQ(ran.status, 0) << ran.said;
  EXPECT_THAT(ran.said, HasSubstr("creep with μ = 1000"));
  EXPECT_EQ(run(fmt::format("{} 99", BYHAND_CASE)).status, 2);
}

}  // namespace
