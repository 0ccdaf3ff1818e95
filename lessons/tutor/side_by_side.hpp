#pragma once

#include <functional>

#include "lessons/tutor/progress.hpp"

namespace byhand::tutor {

/// Calls work(0), …, work(count − 1), each once, on as many threads as there are cores, and tells `progress` (may
/// be none). What one of them throws is thrown here once all threads have stopped.
void side_by_side(int count, const std::function<void(int)>& work, Progress* progress);

}  // namespace byhand::tutor
