#include "solver/support/stamp.hpp"

#include <atomic>

namespace byhand {

std::uint64_t new_stamp() {
  static std::atomic<std::uint64_t> last = 0;
  return ++last;
}

}  // namespace byhand
