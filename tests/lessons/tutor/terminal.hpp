#pragma once

#include <gtest/gtest.h>
#include <poll.h>
#include <pty.h>
#include <signal.h>
#include <sys/wait.h>
#include <unistd.h>

#include <array>
#include <chrono>
#include <map>
#include <string>
#include <vector>

namespace byhand::tests {

/// A program on a terminal of 80 columns, and a reader who types and reads along.
class Terminal {
 public:
  Terminal(std::vector<std::string> command, const std::map<std::string, std::string>& environment) {
    winsize size{24, 80, 0, 0};
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
  bool read_more() {
    pollfd readable{terminal_, POLLIN, 0};
    if (poll(&readable, 1, 60'000) <= 0) return false;
    std::array<char, 4096> buffer{};
    const ssize_t count = read(terminal_, buffer.data(), buffer.size());
    if (count <= 0) return false;
    // A terminal says "\r\n" where the program says "\n".
    for (ssize_t i = 0; i < count; ++i)
      if (buffer[static_cast<size_t>(i)] != '\r') transcript_ += buffer[static_cast<size_t>(i)];
    return true;
  }

  int terminal_ = -1;
  pid_t program_ = -1;
  std::string transcript_;
  size_t read_to_ = 0;
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
