#pragma once

#include <functional>

namespace byhand::course {

class Progress;

/// Calls work(0), …, work(count − 1) in parallel, each once, on one thread per core, and advances `progress`
/// unless it is null. Rethrows the first exception once all threads have stopped.
void side_by_side(int count, const std::function<void(int)>& work, Progress* progress);

}  // namespace byhand::course
