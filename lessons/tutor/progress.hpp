#pragma once

#include <atomic>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace byhand::tutor {

/// Says on standard error what takes longer than a second: a bar on a terminal, one line otherwise, nothing
/// if `quiet`. Speaks from a thread of its own for as long as it lives, so the work needs to call nothing.
class Progress {
 public:
  /// `total` steps are to come; 0 when nobody knows how many.
  Progress(std::string what, int total, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void advance() { ++done_; }
  /// `more` steps are to come beside those that are known.
  void expect(int more) { total_ += more; }

 private:
  void speak();
  void show_bar(int tick) const;

  std::string what_;
  std::atomic<int> total_;
  std::atomic<int> done_{0};
  bool over_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
};

}  // namespace byhand::tutor
