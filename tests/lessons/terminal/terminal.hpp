#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/ioctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <map>
#include <string>
#include <string_view>
#include <vector>

namespace byhand::tests {

/// The size of a terminal.
struct Size {
  unsigned short columns = 80, rows = 24;
};

/// A program on a terminal, and a reader who types, reads along and turns the pages.
class Terminal {
 public:
  Terminal(std::vector<std::string> command, const std::map<std::string, std::string>& environment,
           Size at_first = {}) {
    winsize size{at_first.rows, at_first.columns, 0, 0};
    program_ = forkpty(&terminal_, nullptr, nullptr, &size);
    if (program_ == 0) {
      ::signal(SIGINT, SIG_DFL);  // whoever runs the tests in the background may ignore it
      for (const auto& [name, value] : environment) setenv(name.c_str(), value.c_str(), 1);
      std::vector<char*> argv;
      argv.reserve(command.size() + 1);
      for (std::string& word : command) argv.push_back(word.data());
      argv.push_back(nullptr);
      execv(argv[0], argv.data());
      _exit(127);
    }
  }
  Terminal(const Terminal&) = delete;
  Terminal& operator=(const Terminal&) = delete;
  ~Terminal() {
    if (program_ > 0) {
      kill(program_, SIGKILL);
      waitpid(program_, nullptr, 0);
    }
    close(terminal_);
  }

  void type(const std::string& keys) {
    ASSERT_EQ(write(terminal_, keys.data(), keys.size()), static_cast<ssize_t>(keys.size()));
  }
  void enter(const std::string& line) { type(line + "\n"); }
  void resize(Size now) {
    winsize size{now.rows, now.columns, 0, 0};
    ioctl(terminal_, TIOCSWINSZ, &size);
  }
  /// Whether to press Enter where the program waits at the end of a page.
  void turn_pages(bool turn) { turns_pages_ = turn; }

  /// Reads on until `words` appear behind what was expected before.
  void expect(const std::string& words) {
    const auto deadline = std::chrono::steady_clock::now() + std::chrono::seconds(60);
    while (transcript_.find(words, read_to_) == std::string::npos) {
      if (std::chrono::steady_clock::now() > deadline || !read_more()) {
        FAIL() << "never said: " << words << "\nafter:\n" << transcript_.substr(read_to_);
      }
    }
    read_to_ = transcript_.find(words, read_to_) + words.size();
  }

  /// What was said from the last expectation on, up to `words`.
  std::string said_until(const std::string& words) {
    const size_t from = read_to_;
    expect(words);
    return transcript_.substr(from, read_to_ - from);
  }

  /// The same up to the first of several words, for as long as a lesson may compute.
  std::string said_until_one_of(const std::vector<std::string>& words) {
    const size_t from = read_to_;
    while (true) {
      size_t end = std::string::npos;
      for (const std::string& word : words)
        if (const size_t at = transcript_.find(word, from); at != std::string::npos)
          end = std::min(end, at + word.size());
      if (end != std::string::npos) {
        read_to_ = end;
        return transcript_.substr(from, end - from);
      }
      if (!read_more(300'000)) {
        ADD_FAILURE() << "never said: " << words.front() << "\nafter:\n" << transcript_.substr(from);
        return "What you now know";
      }
    }
  }

  /// What is said until nothing comes for a second.
  std::string said_until_quiet() {
    const size_t from = read_to_;
    while (read_more(1'000)) {
    }
    read_to_ = transcript_.size();
    return transcript_.substr(from);
  }

  /// Whether the terminal echoes keys by itself.
  bool echoes() const {
    termios settings{};
    tcgetattr(terminal_, &settings);
    return (settings.c_lflag & ECHO) != 0;
  }

  /// Whether Ctrl-S stops what is written.
  bool can_be_stopped() const {
    termios settings{};
    tcgetattr(terminal_, &settings);
    return (settings.c_iflag & IXON) != 0;
  }

  /// Reads to the end and returns the exit status, −1 for a signal.
  int leave() {
    while (read_more()) {
    }
    int status = 0;
    waitpid(program_, &status, 0);
    program_ = -1;
    return WIFEXITED(status) ? WEXITSTATUS(status) : -1;
  }

  const std::string& transcript() const { return transcript_; }

 private:
  bool read_more(int milliseconds = 60'000) {
    pollfd readable{terminal_, POLLIN, 0};
    if (poll(&readable, 1, milliseconds) <= 0) return false;
    std::array<char, 4096> buffer{};
    const ssize_t count = read(terminal_, buffer.data(), buffer.size());
    if (count <= 0) return false;
    // A terminal says "\r\n" where the program says "\n".
    for (ssize_t i = 0; i < count; ++i)
      if (buffer[static_cast<size_t>(i)] != '\r') transcript_ += buffer[static_cast<size_t>(i)];
    constexpr std::string_view page_end = " turns the page --";
    for (size_t at = transcript_.find(page_end, turned_to_); turns_pages_ && at != std::string::npos;
         at = transcript_.find(page_end, turned_to_)) {
      turned_to_ = at + page_end.size();
      type("\n");
    }
    return true;
  }

  int terminal_ = -1;
  pid_t program_ = -1;
  std::string transcript_;
  size_t read_to_ = 0, turned_to_ = 0;
  bool turns_pages_ = true;
};

/// Without pseudo-terminals (a bare chroot) nobody can sit at one: such programs say so and test nothing.
class NeedsPseudoTerminals : public testing::Environment {
  void SetUp() override {
    int reader = -1, program = -1;
    if (openpty(&reader, &program, nullptr, nullptr, nullptr) != 0)
      GTEST_SKIP() << "this machine has no pseudo-terminals: mount -t devpts devpts /dev/pts";
    close(reader);
    close(program);
  }
};
inline const testing::Environment* const needs_pseudo_terminals =
    testing::AddGlobalTestEnvironment(new NeedsPseudoTerminals);

}  // namespace byhand::tests
