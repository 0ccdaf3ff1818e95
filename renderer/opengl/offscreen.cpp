#include "renderer/opengl/offscreen.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <condition_variable>
#include <cstdlib>
#include <mutex>
#include <thread>
#include <vector>

#include "renderer/opengl/gl.hpp"
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

}  // namespace

std::unique_ptr<Context> Context::make() {
  // Mesa waits without end for threads that the system refused to start. It asks for one per processor, 16 at
  // most, and for a few that compile and keep shaders.
  if (!can_start(std::clamp(std::thread::hardware_concurrency(), 1u, 16u) + 4)) setenv("LP_NUM_THREADS", "0", 1);
  return offered();
}

std::string describe(Context& context) {
  context.make_current();
  const auto text = [](GLenum name) { return reinterpret_cast<const char*>(glGetString(name)); };
  return fmt::format("{}, OpenGL {}, {}", text(GL_RENDERER), text(GL_VERSION), context.name());
}

}  // namespace byhand::renderer
