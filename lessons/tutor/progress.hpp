#pragma once

#include <atomic>
#include <chrono>
#include <condition_variable>
#include <mutex>
#include <string>
#include <thread>

namespace byhand::tutor {

/// The time that the rest of `total` equal steps takes if `done` of them took `elapsed` seconds: "40 s left",
/// "3 min left". Empty if nothing is done or left.
std::string time_left(double elapsed, int done, int total);

/// Reports work that takes longer than a second on standard error: a progress bar with the time left on a
/// terminal, one line otherwise, nothing if `quiet`. Its own thread prints until it is destroyed.
class Progress {
 public:
  /// `total`: number of steps; 0 if unknown.
  Progress(std::string what, int total, bool quiet);
  Progress(const Progress&) = delete;
  Progress& operator=(const Progress&) = delete;
  ~Progress();

  void advance() { ++done_; }
  /// Adds `more` steps to the total.
  void expect(int more) { total_ += more; }

 private:
  void report();
  void show_bar(int tick) const;
  std::string time_left() const;

  const std::chrono::steady_clock::time_point begin_ = std::chrono::steady_clock::now();
  std::string what_;
  std::atomic<int> total_;
  std::atomic<int> done_{0};
  bool finished_ = false;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
};

}  // namespace byhand::tutor
