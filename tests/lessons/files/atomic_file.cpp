#include "lessons/files/atomic_file.hpp"

#include <gmock/gmock.h>
#include <gtest/gtest.h>
#include <sys/resource.h>
#include <sys/wait.h>
#include <unistd.h>

#include <fmt/format.h>
#include <chrono>
#include <csignal>
#include <filesystem>
#include <fstream>
#include <string>
#include <thread>
#include <vector>

#include "lessons/files/checksum.hpp"
#include "lessons/page/error.hpp"

namespace byhand::course {
namespace {

namespace fs = std::filesystem;
using testing::HasSubstr;

class AtomicFile : public testing::Test {
 protected:
  AtomicFile() { fs::create_directories(folder_); }
  ~AtomicFile() override { fs::remove_all(folder_); }

  std::vector<fs::path> files() const { return {fs::directory_iterator(folder_), fs::directory_iterator()}; }

  const fs::path folder_ = testing::TempDir() + "byhand_atomic_file_" + std::to_string(getpid());
};

TEST_F(AtomicFile, ReplacesAnOlderOneAndMakesFolders) {
  const fs::path folder = folder_ / "deep" / "er", path = folder / "a.txt";
  write_whole(path, "the first text");
  write_whole(path, "another");
  EXPECT_EQ(read_whole(path), "another");
  EXPECT_EQ(std::distance(fs::directory_iterator(folder), fs::directory_iterator()), 1);
}

TEST_F(AtomicFile, HasTheChecksumOfItsBytesAtAnySize) {
  for (const std::size_t size : {0, 1, (1 << 20) - 1, 1 << 20, (1 << 20) + 1, (2 << 20) + 7}) {
    std::string bytes(size, 'a');
    for (std::size_t i = 0; i < size; i += 97) bytes[i] = static_cast<char>(i);
    std::ofstream(folder_ / "file", std::ios::binary) << bytes;
    EXPECT_EQ(sha256_of_file(folder_ / "file"), sha256(bytes)) << size;
  }
  EXPECT_EQ(sha256_of_file(folder_ / "none"), "");
  EXPECT_EQ(sha256_of_file("/dev/zero"), "");
}

TEST_F(AtomicFile, UnderAFileIsRefused) {
  write_whole(folder_ / "file", "no folder");
  try {
    write_whole(folder_ / "file" / "a.txt", "text");
    FAIL();
  } catch (const EnvironmentError& error) {
    EXPECT_THAT(error.what(), HasSubstr((folder_ / "file" / "a.txt").string()));
    EXPECT_THAT(error.what(), HasSubstr("directory"));
  }
  EXPECT_EQ(read_whole(folder_ / "file"), "no folder");
}

TEST_F(AtomicFile, OverAFolderLeavesNothingBehind) {
  fs::create_directories(folder_ / "a.txt" / "inside");
  EXPECT_THROW(write_whole(folder_ / "a.txt", "text"), EnvironmentError);
  EXPECT_EQ(files().size(), 1U);
}

// A limit on the size of files stands in for a full disk: the system refuses the write in the same place.
TEST_F(AtomicFile, OnAFullDiskKeepsTheOldOneAndLeavesNoPart) {
  write_whole(folder_ / "a.txt", "old");
  const pid_t child = fork();
  if (child == 0) {
    std::signal(SIGXFSZ, SIG_IGN);
    const rlimit limit{20000, 20000};
    setrlimit(RLIMIT_FSIZE, &limit);
    try {
      write_whole(folder_ / "a.txt", std::string(120000, 'x'));
    } catch (const EnvironmentError& error) {
      const std::string what = error.what();
      _exit(what.find("a.txt") != std::string::npos && what.find("too large") != std::string::npos ? 0 : 2);
    }
    _exit(1);
  }
  int status = 0;
  waitpid(child, &status, 0);
  ASSERT_TRUE(WIFEXITED(status));
  EXPECT_EQ(WEXITSTATUS(status), 0) << "1: no error; 2: an error that names neither file nor reason";
  EXPECT_EQ(read_whole(folder_ / "a.txt"), "old");
  EXPECT_EQ(files().size(), 1U);
}

TEST_F(AtomicFile, IsNeverBrokenWhenTheWriterIsKilled) {
  const std::string text(700000, 'x');
  int whole = 0;
  for (int round = 0; round < 12; ++round) {
    const pid_t child = fork();
    if (child == 0)
      for (int i = 0;; ++i) write_whole(folder_ / fmt::format("{:04}.txt", i), text);
    // At work, and then at another moment of its work each time.
    while (!fs::exists(folder_ / "0000.txt") && waitpid(child, nullptr, WNOHANG) == 0)
      std::this_thread::sleep_for(std::chrono::milliseconds(1));
    std::this_thread::sleep_for(std::chrono::milliseconds(7 * round));
    kill(child, SIGKILL);
    int status = 0;
    waitpid(child, &status, 0);
    ASSERT_TRUE(WIFSIGNALED(status)) << "the writer ended by itself";
    for (const fs::path& path : files()) {
      if (is_unfinished(path)) continue;
      EXPECT_TRUE(read_whole(path) == text) << path;
      ++whole;
    }
    fs::remove_all(folder_);
    fs::create_directories(folder_);
  }
  EXPECT_GE(whole, 12);
}

}  // namespace
}  // namespace byhand::course
