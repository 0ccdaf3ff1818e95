// Each worked task starts right, reaches its goal, and runs.
#include <gtest/gtest.h>

#include <algorithm>
#include <filesystem>
#include <fstream>
#include <sstream>

#include "lessons/desk/report.hpp"
#include "lessons/desk/scenes.hpp"
#include "lessons/desk/task.hpp"

namespace byhand::desk {
namespace {

namespace fs = std::filesystem;

std::vector<std::pair<std::string, Task>> all_tasks() {
  std::vector<fs::path> files;
  for (const auto& entry : fs::directory_iterator(BYHAND_DESK_TASKS)) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  std::vector<std::pair<std::string, Task>> all;
  for (const fs::path& file : files) {
    std::ostringstream text;
    text << std::ifstream(file).rdbuf();
    all.emplace_back(file.stem().string(), read_task(text.str()));
  }
  return all;
}

Sheet at_the_goal(const Task& task) {
  Sheet sheet;
  for (const auto* lines : {&task.before, &task.start, &task.goal})
    for (const std::string& line : *lines)
      for (const Check& check : sheet.add(line))
        EXPECT_TRUE(check.outcome == Check::Outcome::right || check.outcome == Check::Outcome::told)
            << task.title << "\n"
            << line << "\n"
            << check.sentence;
  return sheet;
}

TEST(DeskTasks, AreTwelveWithAStartAndAGoal) {
  const auto tasks = all_tasks();
  EXPECT_EQ(tasks.size(), 12u);
  for (const auto& [name, task] : tasks) {
    EXPECT_FALSE(task.title.empty()) << name;
    EXPECT_FALSE(task.text.empty()) << name;
    EXPECT_FALSE(task.start.empty()) << name;
    EXPECT_TRUE(at_the_goal(task).complete()) << name;
  }
}

TEST(DeskTasks, RunInTheSolver) {
  for (const auto& [name, task] : all_tasks()) {
    const Sheet sheet = at_the_goal(task);
    const Ran ran = run_in(sheet, "pendulum");
    EXPECT_LT(ran.largest_C, 0.02) << name;
    EXPECT_GT(ran.rows, 0) << name;
  }
}

TEST(DeskTasks, ARodRunsInEveryScene) {
  for (const char* world : {"in the plane", "in space"}) {
    Sheet sheet;
    for (const char* line : {world, "C = |d| - L", "J = [-d/|d|, -(r1 x d)/|d|, d/|d|, r2 x d/|d|]"})
      sheet.add(line);
    for (const char* scene : {"pendulum", "chain", "box"}) {
      const Ran ran = run_in(sheet, scene);
      EXPECT_EQ(ran.rows, std::string(scene) == "chain" ? 2 : 1);
      // A step off the arc of an arm, ½h²v²/r, of which Baumgarte takes β: at most with the energy of two links
      // that fall by 8 m, v² = 2 · 2 · 9.81 · 8 m²/s², in one arm of 0.25 m.
      EXPECT_LT(ran.largest_C, 0.5 / (240.0 * 240) * (2 * 2 * 9.81 * 8) / 0.25 / 0.2) << world << " " << scene;
      EXPECT_GT(ran.largest_C, 0) << "it moves";
    }
    EXPECT_NE(run_scene(sheet, "moon").find("There is no scene"), std::string::npos);
  }
}

TEST(DeskTasks, ARunBeginsWithThePartsOfJOnTheBodies) {
  Sheet sheet;
  for (const char* line : {"C = |p2 - p1|^2/2 - L^2/2", "J = [-d, -(r1 x d), d, r2 x d]"}) sheet.add(line);
  const Ran ran = run_in(sheet, "chain");
  EXPECT_EQ(ran.moments.size(), 1u + 5 * 60);
  EXPECT_EQ(ran.moves, (std::vector<bool>{false, true, true}));
  for (const Moment& moment : ran.moments) {
    ASSERT_EQ(moment.parts.size(), 4u);
    for (std::size_t rod = 0; rod < 2; ++rod) {
      const Parts &first = moment.parts[2 * rod], &second = moment.parts[2 * rod + 1];
      EXPECT_EQ(first.body, rod);
      EXPECT_EQ(second.body, rod + 1);
      EXPECT_EQ(first.linear[0], -second.linear[0]);
      EXPECT_EQ(first.linear[1], -second.linear[1]);
      // J's torque about any point vanishes: Σ x × l + a = 0.
      double torque = 0;
      for (const Parts& part : {first, second}) {
        const Point& x = moment.centres[part.body];
        torque += x[0] * part.linear[1] - x[1] * part.linear[0] + part.angular;
      }
      EXPECT_NEAR(torque, 0, 1e-12);
      EXPECT_NEAR(std::hypot(second.linear[0], second.linear[1]), 2, 0.02) << "d is as long as the rod, 2 m";
    }
    for (const auto& corners : moment.corners) {
      ASSERT_EQ(corners.size(), 4u);
      EXPECT_NEAR(std::hypot(corners[0][0] - corners[2][0], corners[0][1] - corners[2][1]), std::hypot(0.5, 0.2),
                  1e-12);
    }
  }
}

TEST(DeskTasks, ABoxHasFourEdgesInThePlaneAndTwelveInSpace) {
  const auto edges = [](std::size_t corners) {
    int count = 0;
    for (std::size_t i = 0; i < corners; ++i)
      for (std::size_t j = i + 1; j < corners; ++j) count += is_edge(i, j);
    return count;
  };
  EXPECT_EQ(edges(4), 4);
  EXPECT_EQ(edges(8), 12);
}

}  // namespace
}  // namespace byhand::desk
