#include "renderer/png.hpp"

#include <fcntl.h>
#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <chrono>
#include <csignal>
#include <fstream>
#include <iterator>
#include <random>
#include <thread>

#include "renderer/error.hpp"
#include "renderer/file.hpp"

namespace byhand::renderer {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class Png : public testing::Test {
 protected:
  Png() { fs::create_directories(folder_); }
  ~Png() override { fs::remove_all(folder_); }

  std::vector<fs::path> files() const { return {fs::directory_iterator(folder_), fs::directory_iterator()}; }

  const fs::path folder_ = testing::TempDir() + "byhand_png_" + std::to_string(getpid());
};

Image noise(int width, int height) {
  std::mt19937 random(20131207);
  Image image{width, height, {}};
  for (int i = 0; i < 3 * width * height; ++i) image.rgb.push_back(std::uint8_t(random()));
  return image;
}

std::string read(const fs::path& path) {
  std::ifstream in(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(in), {}};
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

TEST_F(Png, ReplacesAnOlderFileAndMakesFolders) {
  const fs::path path = folder_ / "deep" / "er" / "a.png";
  write_png(path, noise(8, 8));
  write_png(path, noise(9, 9));
  EXPECT_EQ(read_png(path).width, 9);
  EXPECT_FALSE(fs::exists(path.string() + ".part"));
}

TEST_F(Png, RefusesAnImageWhoseSizeIsNotItsBytes) {
  EXPECT_THROW(encode_png({}), std::invalid_argument);
  EXPECT_THROW(encode_png({-3, 2, std::vector<std::uint8_t>(18)}), std::invalid_argument);
  Image image = noise(4, 4);
  image.rgb.pop_back();
  EXPECT_THROW(write_png(folder_ / "a.png", image), std::invalid_argument);
  EXPECT_TRUE(files().empty());
}

TEST_F(Png, SaysWhichFileItCannotRead) {
  try {
    read_png(folder_ / "absent.png");
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr("absent.png"));
  }
}

TEST_F(Png, UnderAFolderThatCannotBeWrittenIsRefused) {
  write_whole(folder_ / "file", "no folder");
  try {
    write_png(folder_ / "file" / "a.png", noise(4, 4));
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr((folder_ / "file" / "a.png").string()));
    EXPECT_THAT(error.what(), HasSubstr("directory"));
  }
  EXPECT_EQ(read(folder_ / "file"), "no folder");
}

TEST_F(Png, OverAFolderLeavesNothingBehind) {
  fs::create_directories(folder_ / "a.png" / "inside");
  EXPECT_THROW(write_png(folder_ / "a.png", noise(4, 4)), EnvironmentError);
  EXPECT_EQ(files().size(), 1u);
}

// A limit on the size of files stands in for a full disk: the system refuses the write in the same place.
TEST_F(Png, OnAFullDiskKeepsTheOldFileAndLeavesNoPart) {
  const Image old = noise(8, 8);
  write_png(folder_ / "a.png", old);
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{20000, 20000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_png(folder_ / "a.png", noise(200, 200));
    } catch (const EnvironmentError& error) {
      const std::string what = error.what();
      _exit(what.find("a.png") != std::string::npos && what.find("too large") != std::string::npos ? 0 : 2);
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << "1: no error; 2: an error that names neither file nor reason";
  EXPECT_EQ(read_png(folder_ / "a.png"), old);
  EXPECT_EQ(files().size(), 1u);
}

TEST_F(Png, IsNeverBrokenWhenTheWriterIsKilled) {
  int whole = 0;
  for (int round = 0; round < 12; ++round) {
    const pid_t child = fork();
    if (child == 0) {
      execl(WRITE_FOREVER, WRITE_FOREVER, folder_.c_str(), nullptr);
      _exit(127);
    }
    // At work, and then at another moment of its work each time.
    while (!fs::exists(folder_ / "0000.png") && waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * round));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the writer ended by itself";
    for (const fs::path& path : files()) {
      if (path.extension() != ".png") continue;
      EXPECT_NO_THROW(EXPECT_EQ(read_png(path).width, 640)) << path;
      ++whole;
    }
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  EXPECT_GE(whole, 12);
}

}  // namespace
}  // namespace byhand::renderer
