#include "renderer/png.hpp"

#include <gtest/gtest.h>
#include <unistd.h>

#include <fstream>
#include <random>
#include <thread>

#include "tests/renderer/png_file.hpp"

namespace byhand::renderer {
namespace {

namespace fs = std::filesystem;

class Png : public testing::Test {
 protected:
  Png() { fs::create_directories(folder_); }
  ~Png() override { fs::remove_all(folder_); }

  const fs::path folder_ = testing::TempDir() + "byhand_png_" + std::to_string(getpid());
};

Image noise(int width, int height) {
  std::mt19937 random(20131207);
  Image image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(std::uint8_t(random()));
  return image;
}

TEST_F(Png, IsReadBackAsItWasWritten) {
  for (const auto& [width, height] : {std::pair(1, 1), std::pair(7, 3), std::pair(64, 100)}) {
    const Image image = noise(width, height);
    write_png(folder_ / "a.png", image);
    EXPECT_EQ(read_png(folder_ / "a.png"), image);
  }
}

TEST_F(Png, HasTheSameBytesEveryTime) {
  const Image image = noise(33, 21);
  const std::string once = encode_png(image);
  EXPECT_EQ(once, encode_png(image));
  std::string elsewhere;
  std::thread([&] { elsewhere = encode_png(image); }).join();
  EXPECT_EQ(once, elsewhere);
}

TEST_F(Png, IsSmallerWithThoroughCompressionAndHasTheSamePixels) {
  Image image = noise(64, 64);
  for (int y = 0; y < 64; ++y)
    for (int x = 0; x < 64; ++x)
      for (int channel = 0; channel < 3; ++channel)
        image.rgb[3 * std::size_t(64 * y + x) + channel] = std::uint8_t((x * x + y * y) / 40 + channel);
  const std::string thorough = encode_png(image, Compression::thorough);
  EXPECT_LT(thorough.size(), encode_png(image, Compression::quick).size());
  std::ofstream(folder_ / "a.png", std::ios::binary) << thorough;
  EXPECT_EQ(read_png(folder_ / "a.png"), image);
}

TEST_F(Png, RefusesAnImageWhoseSizeIsNotItsBytes) {
  EXPECT_THROW(encode_png({}), std::invalid_argument);
  EXPECT_THROW(encode_png({-3, 2, std::vector<std::uint8_t>(18)}), std::invalid_argument);
  Image image = noise(4, 4);
  image.rgb.pop_back();
  EXPECT_THROW(encode_png(image), std::invalid_argument);
}

}  // namespace
}  // namespace byhand::renderer
