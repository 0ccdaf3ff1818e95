// Progress on standard error does not tear the text on standard output, and tells the time left.

#include "lessons/page/progress.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <gtest/gtest.h>
#include <sys/wait.h>
#include <unistd.h>

#include <thread>

#include "tests/lessons/terminal/process.hpp"

namespace byhand::tests {
namespace {

using course::time_left;

TEST(TimeLeft, IsThatOfTheRestAtThePaceSoFar) {
  EXPECT_EQ(time_left(10, 1, 5), "40 s left");
  EXPECT_EQ(time_left(10, 4, 5), "3 s left") << "rounded up: nothing takes 0 s";
  EXPECT_EQ(time_left(1, 1, 100), "99 s left");
  EXPECT_EQ(time_left(1, 1, 122), "3 min left");
}

TEST(TimeLeft, IsUnknownBeforeTheFirstPieceAndNoneAfterTheLast) {
  EXPECT_EQ(time_left(10, 0, 5), "");
  EXPECT_EQ(time_left(10, 0, 0), "");
  EXPECT_EQ(time_left(10, 5, 5), "");
}

TEST(Progress, LeavesLettersWholeWhenBothStreamsGoToOneFile) {
  const Folder folder;
  const std::string path = (folder / "both").string();
  const pid_t child = fork();
  if (child == 0) {
    const int file = open(path.c_str(), O_CREAT | O_WRONLY | O_APPEND, 0600);
    dup2(file, STDOUT_FILENO);
    dup2(file, STDERR_FILENO);
    // A buffer of 4096 bytes is written in the middle of the second λ.
    std::setvbuf(stdout, nullptr, _IOFBF, 4096);
    for (const char* words : {"x", "λ"}) std::fwrite(words, 1, std::string_view(words).size(), stdout);
    for (int i = 0; i < 3000; ++i) std::fwrite("λ", 1, 2, stdout);
    {
      course::Progress progress("drawing", 0, false);
      std::this_thread::sleep_for(std::chrono::milliseconds(1300));
    }
    std::fflush(stdout);
    _exit(0);
  }
  waitpid(child, nullptr, 0);
  const std::string both = contents(path);
  EXPECT_NE(both.find("drawing …\n"), std::string::npos);
  for (size_t at = both.find("\xCE"); at != std::string::npos; at = both.find("\xCE", at + 1))
    ASSERT_EQ(both.substr(at, 2), "λ") << "at byte " << at;
}

}  // namespace
}  // namespace byhand::tests
