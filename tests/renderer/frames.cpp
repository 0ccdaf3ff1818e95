#include "renderer/frames.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <unistd.h>

#include "renderer/error.hpp"
#include "renderer/file.hpp"
#include "renderer/palette.hpp"
#include "renderer/png.hpp"

namespace byhand::renderer {
namespace {

namespace fs = std::filesystem;

Image plain(int width, int height, int shade) {
  return {width, height, std::vector<std::uint8_t>(3 * std::size_t(width) * height, std::uint8_t(shade))};
}

class Frames : public testing::TestWithParam<FrameWriter::Encoding> {
 protected:
  ~Frames() override { fs::remove_all(folder_); }
  const fs::path folder_ = testing::TempDir() + "byhand_frames_" + std::to_string(getpid());
};

TEST_P(Frames, AreAllWrittenInOrder) {
  FrameWriter writer(folder_, GetParam());
  for (int i = 0; i < 30; ++i) writer.write(plain(40, 30, i));
  writer.finish();
  EXPECT_EQ(writer.count(), 30);
  EXPECT_EQ(writer.path(7), folder_ / "0007.png");
  for (int i = 0; i < 30; ++i) EXPECT_EQ(read_png(writer.path(i)), plain(40, 30, i));
  EXPECT_FALSE(fs::exists(writer.path(30)));
}

TEST_P(Frames, CarryAnErrorBackToTheCaller) {
  write_whole(folder_ / "file", "in the way");
  FrameWriter writer(folder_ / "file", GetParam());
  const auto write_and_finish = [&] {
    for (int i = 0; i < 20; ++i) writer.write(plain(40, 30, i));
    writer.finish();
  };
  EXPECT_THROW(write_and_finish(), EnvironmentError);
}

TEST_P(Frames, AnErrorOfTheLastFrameIsNotLost) {
  write_whole(folder_ / "file", "in the way");
  FrameWriter writer(folder_ / "file", GetParam());
  const auto write_and_finish = [&] {
    writer.write(plain(40, 30, 1));
    writer.finish();
  };
  EXPECT_THROW(write_and_finish(), EnvironmentError);
}

TEST_P(Frames, AnAbandonedWriterEndsCleanly) {
  { FrameWriter writer(folder_, GetParam()); }
  {
    FrameWriter writer(folder_, GetParam());
    for (int i = 0; i < 6; ++i) writer.write(plain(400, 300, i));
  }
  if (!fs::exists(folder_)) return;
  for (const auto& entry : fs::directory_iterator(folder_)) EXPECT_NO_THROW(read_png(entry.path()));
}

INSTANTIATE_TEST_SUITE_P(Encoding, Frames,
                         testing::Values(FrameWriter::Encoding::beside, FrameWriter::Encoding::at_once),
                         [](const auto& encoding) {
                           return encoding.param == FrameWriter::Encoding::beside ? "Beside" : "AtOnce";
                         });

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
