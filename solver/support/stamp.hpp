#pragma once

#include <cstdint>

namespace byhand {

/// A number that no other call returns.
std::uint64_t new_stamp();

}  // namespace byhand
