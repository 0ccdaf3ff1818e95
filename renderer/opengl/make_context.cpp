// Native alone: a browser has one context, its worker's.

#include "renderer/opengl/offscreen.hpp"

#include <fmt/format.h>
#include <sys/mman.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/error.hpp"
#include "renderer/threads.hpp"

namespace byhand::renderer {
namespace {

/// Whether so many threads can be started at once.
bool can_start(unsigned count) {
  std::mutex mutex;
  std::condition_variable changed;
  bool done = false;
  std::vector<std::thread> threads;
  for (unsigned i = 0; i < count; ++i)
    threads.push_back(started_thread([&] {
      std::unique_lock lock(mutex);
      changed.wait(lock, [&] { return done; });
    }));
  {
    const std::lock_guard lock(mutex);
    done = true;
  }
  changed.notify_all();
  bool all = true;
  for (std::thread& thread : threads)
    if (thread.joinable())
      thread.join();
    else
      all = false;
  return all;
}

bool can_reserve(size_t bytes) {
  void* const reserved = mmap(nullptr, bytes, PROT_NONE, MAP_PRIVATE | MAP_ANONYMOUS | MAP_NORESERVE, -1, 0);
  return reserved != MAP_FAILED && munmap(reserved, bytes) == 0;
}

}  // namespace

std::unique_ptr<Context> Context::make() {
  // Mesa starts a thread per processor, 16 at most, and a few that compile and keep shaders. It crashes where they
  // find no memory (300 MiB for 6 of them), and waits without end for those that the system refused to start.
  const unsigned threads = std::clamp(std::thread::hardware_concurrency(), 1u, 16u) + 4;
  const size_t mebibytes = 256 + 32 * threads;
  if (!can_reserve(mebibytes << 20))
    throw Unavailable(
        fmt::format("OSMesa needs {} MiB of memory to draw, and a limit leaves less: see ulimit -v.", mebibytes));
  if (!can_start(threads)) setenv("LP_NUM_THREADS", "0", 1);
  return offered();
}

}  // namespace byhand::renderer
