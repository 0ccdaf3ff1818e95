#include "renderer/frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include <filesystem>
#include <fstream>
#include <stdexcept>

#include "renderer/palette.hpp"
#include "tests/renderer/png_file.hpp"

namespace byhand::renderer {
namespace {

namespace fs = std::filesystem;

Image plain(int width, int height, int shade) {
  return {width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * height, std::uint8_t(shade))};
}

Image decoded(std::string_view png) {
  const fs::path path = testing::TempDir() + "byhand_frame_" + std::to_string(getpid()) + ".png";
  std::ofstream(path, std::ios::binary) << png;
  Image image = read_png(path);
  fs::remove(path);
  return image;
}

TEST(Frames, ReachTheSinkInOrder) {
  std::vector<Image> images;
  FrameEncoder encoder([&](int index, std::string_view png) {
    EXPECT_EQ(index, int(images.size()));
    images.push_back(decoded(png));
  });
  for (int i = 0; i < 30; ++i) encoder.add(plain(40, 30, i));
  encoder.finish();
  ASSERT_EQ(images.size(), 30U);
  for (int i = 0; i < 30; ++i) EXPECT_EQ(images[std::size_t(i)], plain(40, 30, i));
}

[[noreturn]] void refuse(int, std::string_view) { throw std::domain_error("the disk is full"); }

TEST(Frames, CarryAnErrorBackToTheCaller) {
  FrameEncoder encoder(refuse);
  const auto add_and_finish = [&] {
    for (int i = 0; i < 20; ++i) encoder.add(plain(40, 30, i));
    encoder.finish();
  };
  EXPECT_THROW(add_and_finish(), std::domain_error);
}

TEST(Frames, AnErrorOfTheLastFrameIsNotLost) {
  FrameEncoder encoder(refuse);
  const auto add_and_finish = [&] {
    encoder.add(plain(40, 30, 1));
    encoder.finish();
  };
  EXPECT_THROW(add_and_finish(), std::domain_error);
}

TEST(Frames, AnAbandonedEncoderEndsCleanly) {
  int encoded = 0;
  const auto count = [&](int, std::string_view png) {
    EXPECT_EQ(decoded(png).width, 400);
    ++encoded;
  };
  { FrameEncoder encoder(count); }
  EXPECT_EQ(encoded, 0);
  {
    FrameEncoder encoder(count);
    for (int i = 0; i < 6; ++i) encoder.add(plain(400, 300, i));
  }
  EXPECT_LE(encoded, 6);
}

TEST(Strip, ShowsEachImageInItsPlace) {
  std::vector<Image> images;
  for (int i = 0; i < 6; ++i) images.push_back(plain(160, 90, 40 * i));
  const Image sheet = strip(images, 3, 332, 8);
  EXPECT_EQ(sheet.width, 332);
  EXPECT_EQ(sheet.height, 2 * (56 + 8) + 8);  // cells of 100 × 56
  for (int i = 0; i < 6; ++i) {
    const int x = 8 + i % 3 * 108 + 50, y = 8 + i / 3 * 64 + 28;
    EXPECT_EQ(sheet.pixel(x, y)[0], 40 * i);
  }
  EXPECT_EQ(sheet.pixel(2, 2)[2], palette::paper.b);
}

TEST(Strip, RefusesImagesOfDifferentSizeAndNone) {
  const std::vector<Image> uneven{plain(16, 9, 0), plain(16, 10, 0)};
  EXPECT_THROW(strip(uneven, 2), std::invalid_argument);
  EXPECT_THROW(strip({}, 2), std::invalid_argument);
  EXPECT_THROW(strip(std::vector<Image>{plain(16, 9, 0)}, 0), std::invalid_argument);
}

TEST(Strip, SpreadHoldsFirstAndLast) {
  EXPECT_THAT(spread(100, 6), testing::ElementsAre(0, 19, 39, 59, 79, 99));
  EXPECT_THAT(spread(3, 6), testing::ElementsAre(0, 1, 2));
  EXPECT_THAT(spread(5, 1), testing::ElementsAre(4));
  EXPECT_THAT(spread(1, 6), testing::ElementsAre(0));
  EXPECT_TRUE(spread(0, 6).empty());
}

}  // namespace
}  // namespace byhand::renderer
