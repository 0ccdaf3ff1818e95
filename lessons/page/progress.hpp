#pragma once

#include <memory>
#include <string>

namespace byhand::course {

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

  void advance();
  /// Adds `more` steps to the total.
  void expect(int more);

 private:
  struct Reporter;
  std::unique_ptr<Reporter> reporter_;
};

}  // namespace byhand::course
