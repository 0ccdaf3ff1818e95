#pragma once

#include <sys/types.h>

#include <cstddef>
#include <filesystem>
#include <string>
#include <vector>

#include "lessons/practise/judge/stopped.hpp"
#include "lessons/practise/judge/wire.hpp"

namespace byhand::practise {

struct Limits {
  double seconds = 2;  // of computing: a busy machine takes longer by the clock
  std::size_t bytes = 256u << 20;
};

/// The process that runs a learner's functions. It gets no files, no network, no environment and no further
/// processes where the system has seccomp; it has one socket to the judge, and what it prints is kept.
class Process {
 public:
  explicit Process(const std::filesystem::path& program, Limits limits = {});
  Process(const Process&) = delete;
  Process& operator=(const Process&) = delete;
  ~Process();

  /// Throws Stopped if no answer comes. All calls together may compute for `limits.seconds`, and sleep for as
  /// many.
  Numbers call(std::size_t which, const Numbers& arguments);

  /// The first lines that the learner's code printed.
  std::string printed() const;

 private:
  double received();
  void receive(void* bytes, std::size_t count);
  [[noreturn]] void wrote_on_the_channel();
  [[noreturn]] void ended();
  [[noreturn]] void end(const std::string& sentence);

  Limits limits_;
  double waited_ = 0, slept_ = 0;  // for answers, and how long it slept meanwhile [s]
  bool ready_ = false;             // its main has begun
  pid_t child_ = -1;
  int socket_ = -1, print_ = -1;
};

struct Finished {
  int status = 0;  // −1: it took too long or was killed
  std::string said;
};

/// Runs a program that may read the system and `readable`, and write 64 MB into `folder` alone, where the system
/// has Landlock. `limits.seconds` are by the clock.
Finished run_confined(const std::vector<std::string>& command, const std::vector<std::filesystem::path>& readable,
                      const std::filesystem::path& folder, Limits limits);

/// A folder that is gone with its last user.
class Scratch {
 public:
  Scratch();
  Scratch(const Scratch&) = delete;
  Scratch& operator=(const Scratch&) = delete;
  ~Scratch();
  const std::filesystem::path& path() const { return path_; }

 private:
  std::filesystem::path path_;
};

}  // namespace byhand::practise
