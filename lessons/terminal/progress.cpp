#include "lessons/page/progress.hpp"

#include <fmt/format.h>
#include <unistd.h>

#include <atomic>
#include <chrono>
#include <cmath>
#include <condition_variable>
#include <csignal>
#include <cstdlib>
#include <mutex>
#include <string_view>
#include <thread>

#include "lessons/files/streams.hpp"
#include "renderer/threads.hpp"

namespace byhand::course {

using namespace std::chrono_literals;

std::string time_left(double elapsed, int done, int total) {
  if (done <= 0 || done >= total) return "";
  const double seconds = elapsed * (total - done) / done;
  return seconds < 100 ? fmt::format("{:.0f} s left", std::ceil(seconds))
                       : fmt::format("{:.0f} min left", std::ceil(seconds / 60));
}

struct Progress::Reporter {
  Reporter(std::string what_, int total_) : what(std::move(what_)), total(total_) {}

  void report();
  void show_bar(int tick) const;
  std::string time_left() const;

  const std::chrono::steady_clock::time_point begin = std::chrono::steady_clock::now();
  std::string what;
  std::atomic<int> total;
  std::atomic<int> done{0};
  bool finished = false;
  std::mutex mutex;
  std::condition_variable changed;
  std::thread thread;
};

Progress::Progress(std::string what, int total, bool quiet)
    : reporter_(std::make_unique<Reporter>(std::move(what), total)) {
  if (!quiet) reporter_->thread = renderer::started_thread([this] { reporter_->report(); });
}

Progress::~Progress() {
  if (!reporter_->thread.joinable()) return;
  {
    const std::lock_guard lock(reporter_->mutex);
    reporter_->finished = true;
  }
  reporter_->changed.notify_all();
  reporter_->thread.join();
}

void Progress::advance() { ++reporter_->done; }
void Progress::expect(int more) { reporter_->total += more; }

void Progress::Reporter::report() {
  // Only the thread that prompts the reader handles Ctrl-C.
  sigset_t signals;
  sigfillset(&signals);
  pthread_sigmask(SIG_BLOCK, &signals, nullptr);

  std::unique_lock lock(mutex);
  const auto is_finished = [this] { return finished; };
  if (changed.wait_for(lock, 1s, is_finished)) return;
  const char* const terminal = std::getenv("TERM");
  if (!isatty(STDERR_FILENO) || !terminal || std::string_view(terminal) == "dumb") {
    // Both streams may go to one file: a buffer may have been written up to the middle of a letter.
    std::fflush(stdout);
    const std::string left = time_left();
    complain(fmt::format("{}{}{} …\n", what, left.empty() ? "" : ", ", left));
    return;
  }
  for (int tick = 0; !finished; ++tick) {
    show_bar(tick);
    changed.wait_for(lock, 200ms, is_finished);
  }
  complain("\r\033[K");
}

std::string Progress::Reporter::time_left() const {
  const std::chrono::duration<double> elapsed = std::chrono::steady_clock::now() - begin;
  return course::time_left(elapsed.count(), done, total);
}

void Progress::Reporter::show_bar(int tick) const {
  constexpr int width = 24;
  std::string bar;
  if (const int all = total; all > 0) {
    const int filled = done * width / all;
    for (int i = 0; i < width; ++i) bar += i < filled ? "━" : "╌";
    const std::string left = time_left();
    bar += fmt::format(" {}/{}{}{}", done.load(), all, left.empty() ? "" : ", ", left);
  } else {
    for (int i = 0; i < width; ++i) bar += i == tick % width ? "━" : "╌";
  }
  complain(fmt::format("\r\033[K{} {}", bar, what));
}

}  // namespace byhand::course
