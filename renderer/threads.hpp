#pragma once

#include <system_error>
#include <thread>
#include <utility>

namespace byhand::renderer {

/// A thread that does the work, or one that is not joinable where the system starts no more threads for us, as
/// under a limit on processes.
template <class Work>
std::thread started_thread(Work&& work) {
  try {
    return std::thread(std::forward<Work>(work));
  } catch (const std::system_error&) {
    return {};
  }
}

}  // namespace byhand::renderer
