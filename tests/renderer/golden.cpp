// Each scene against a stored picture that somebody has looked at. After a wanted change:
//   BYHAND_RENEW_GOLDEN=1 ctest -R Golden
// writes the stored pictures anew; look at them before they are committed.

#include <gtest/gtest.h>

#include <cstdlib>
#include <filesystem>

#include "renderer/opengl/pixel_canvas.hpp"
#include "tests/renderer/png_file.hpp"
#include "tests/renderer/scenes.hpp"

namespace byhand::renderer {
namespace {

class Golden : public testing::TestWithParam<scenes::Scene> {};

TEST_P(Golden, FrameIsTheOneThatWasLookedAt) {
  PixelCanvas canvas(426, 240);
  GetParam().draw(canvas);
  const Image actual = canvas.image();
  const std::string name = std::string(GetParam().name) + ".png";
  const std::filesystem::path stored = std::filesystem::path(GOLDEN_FOLDER) / name;
  if (std::getenv("BYHAND_RENEW_GOLDEN")) {
    write_png(stored, actual);
    GTEST_SKIP() << "wrote " << stored << ": look at it";
  }

  const Image expected = read_png(stored);
  ASSERT_EQ(expected.width, actual.width);
  ASSERT_EQ(expected.height, actual.height);
  Image difference = expected;
  int off = 0;
  for (std::size_t i = 0; i < actual.rgb.size(); ++i) {
    const int d = std::abs(actual.rgb[i] - expected.rgb[i]);
    off += d > 1;
    difference.rgb[i] = std::uint8_t(std::min(255, 20 * d));
  }
  // At most one of 255 a channel, on all but one of 100,000 values.
  if (off <= 1e-5 * double(actual.rgb.size())) return;
  const std::filesystem::path folder = std::filesystem::path(DIFFERENCE_FOLDER) / GetParam().name;
  write_png(folder / "expected.png", expected);
  write_png(folder / "actual.png", actual);
  write_png(folder / "difference.png", difference);
  FAIL() << off << " of " << actual.rgb.size()
         << " values differ: see expected.png, actual.png and difference.png (× 20) in " << folder;
}

INSTANTIATE_TEST_SUITE_P(Scenes, Golden, testing::ValuesIn(scenes::all),
                         [](const auto& scene) { return std::string(scene.param.name); });

}  // namespace
}  // namespace byhand::renderer
