#include "lessons/page/side_by_side.hpp"

#include <algorithm>
#include <atomic>
#include <csignal>
#include <exception>
#include <mutex>
#include <thread>
#include <vector>

#include "lessons/page/progress.hpp"
#include "renderer/threads.hpp"

namespace byhand::course {

void side_by_side(int count, const std::function<void(int)>& work, Progress* progress) {
  if (progress) progress->expect(count);
  std::atomic<int> next{0};
  std::mutex mutex;
  std::exception_ptr failure;
  const auto run = [&] {
    for (int i = next++; i < count; i = next++) {
      try {
        work(i);
      } catch (...) {
        const std::lock_guard lock(mutex);
        if (!failure) failure = std::current_exception();
        next = count;
      }
      if (progress) progress->advance();
    }
  };

  // The threads inherit the mask: only the thread that prompts the reader handles Ctrl-C.
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  std::vector<std::thread> others;
  const int cores = static_cast<int>(std::max(1u, std::thread::hardware_concurrency()));
  for (int i = 1; i < std::min(cores, count); ++i) others.push_back(renderer::started_thread(run));
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  run();
  for (std::thread& other : others)
    if (other.joinable()) other.join();
  if (failure) std::rethrow_exception(failure);
}

}  // namespace byhand::course
