#include "lessons/tutor/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <cmath>
#include <csignal>
#include <cstdlib>
#include <string_view>

#include "lessons/tutor/streams.hpp"

namespace byhand::tutor {

using namespace std::chrono_literals;

std::string time_left(double elapsed, int done, int total) {
  if (done <= 0 || done >= total) return "";
  const double seconds = elapsed * (total - done) / done;
  return seconds < 100 ? fmt::format("{:.0f} s left", std::ceil(seconds))
                       : fmt::format("{:.0f} min left", std::ceil(seconds / 60));
}

Progress::Progress(std::string what, int total, bool quiet) : what_(std::move(what)), total_(total) {
  if (!quiet) thread_ = std::thread([this] { report(); });
}

Progress::~Progress() {
  if (!thread_.joinable()) return;
  {
    const std::lock_guard lock(mutex_);
    finished_ = true;
  }
  changed_.notify_all();
  thread_.join();
}

void Progress::report() {
  // Only the thread that prompts the reader handles Ctrl-C.
  sigset_t signals;
  sigfillset(&signals);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  std::unique_lock lock(mutex_);
  const auto finished = [this] { return finished_; };
  if (changed_.wait_for(lock, 1s, finished)) return;
  const char* const terminal = std::getenv("TERM");
  if (!isatty(STDERR_FILENO) || !terminal || std::string_view(terminal) == "dumb") {
    // Both streams may go to one file: a buffer may have been written up to the middle of a letter.
    std::fflush(stdout);
    const std::string left = time_left();
    complain(fmt::format("{}{}{} …\n", what_, left.empty() ? "" : ", ", left));
    return;
  }
  for (int tick = 0; !finished_; ++tick) {
    show_bar(tick);
    changed_.wait_for(lock, 200ms, finished);
  }
  complain("\r\033[K");
}

std::string Progress::time_left() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin_;
  return tutor::time_left(elapsed.count(), done_, total_);
}

void Progress::show_bar(int tick) const {
  constexpr int width = 24;
  std::string bar;
  if (const int total = total_; total > 0) {
    const int filled = done_ * width / total;
    for (int i = 0; i < width; ++i) bar += i < filled ? "━" : "╌";
    const std::string left = time_left();
    bar += fmt::format(" {}/{}{}{}", done_.load(), total, left.empty() ? "" : ", ", left);
  } else {
    for (int i = 0; i < width; ++i) bar += i == tick % width ? "━" : "╌";
  }
  complain(fmt::format("\r\033[K{} {}", bar, what_));
}

}  // namespace byhand::tutor
