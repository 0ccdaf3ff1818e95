// The same options give the same bytes: on either backend, with any number of threads, on wide and narrow
// processors.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>

#include "renderer/opengl/pixel_canvas.hpp"
#include "tests/renderer/scenes.hpp"

namespace byhand::renderer {
namespace {

// Draws all scenes with the given program and environment and returns the bytes of their files.
std::vector<std::string> drawn(const std::string& program, const std::string& environment) {
  const std::filesystem::path folder = testing::TempDir() + "byhand_pixels_" + std::to_string(getpid());
  const std::string command = environment + " '" + program + "' '" + folder.string() + "'";
  EXPECT_EQ(std::system(command.c_str()), 0) << command;
  std::vector<std::string> files;
  for (const scenes::Scene& scene : scenes::all) {
    std::ifstream in(folder / (std::string(scene.name) + ".png"), std::ios::binary);
    files.emplace_back(std::istreambuf_iterator<char>(in), std::istreambuf_iterator<char>());
    EXPECT_FALSE(files.back().empty()) << scene.name;
  }
  std::filesystem::remove_all(folder);
  return files;
}

TEST(Pixels, AreTheSameTwiceInARow) { EXPECT_EQ(drawn(DRAW_SCENES, ""), drawn(DRAW_SCENES, "")); }

TEST(Pixels, DoNotDependOnTheNumberOfThreads) {
  EXPECT_EQ(drawn(DRAW_SCENES, "LP_NUM_THREADS=0"), drawn(DRAW_SCENES, "LP_NUM_THREADS=2"));
}

TEST(Pixels, DoNotDependOnTheProcessorsVectorWidth) {
  EXPECT_EQ(drawn(DRAW_SCENES, "LP_NATIVE_VECTOR_WIDTH=128"), drawn(DRAW_SCENES, "LP_NATIVE_VECTOR_WIDTH=256"));
}

TEST(Pixels, AreTheSameFromOSMesaAndEgl) {
  const std::string alternative = DRAW_SCENES_ALTERNATIVE;
  if (alternative.empty()) GTEST_SKIP() << "only one of OSMesa and EGL is installed";
  EXPECT_EQ(drawn(DRAW_SCENES, ""), drawn(alternative, ""));
}

TEST(Pixels, ASecondImageOfAPageIsTheSame) {
  PixelCanvas canvas(320, 180);
  scenes::pendulum(canvas);
  const Image first = canvas.image();
  EXPECT_EQ(first, canvas.image());
  canvas.clear();
  scenes::shapes(canvas);
  EXPECT_NE(first, canvas.image());
  canvas.clear();
  scenes::pendulum(canvas);
  EXPECT_EQ(first, canvas.image()) << "what was drawn before left a trace";
}

TEST(Pixels, TwoCanvasesDoNotDisturbEachOther) {
  PixelCanvas one(320, 180), other(200, 160);
  scenes::pendulum(one);
  const Image before = one.image();
  scenes::shapes(other);
  EXPECT_EQ(other.image().width, 200);
  EXPECT_EQ(one.image(), before);
}

}  // namespace
}  // namespace byhand::renderer
