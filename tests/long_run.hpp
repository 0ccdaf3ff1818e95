#pragma once

#include <cstdlib>
#include <string_view>

namespace byhand::tests {

/// Whether everything is tried, however long it takes: ./tests/run --settings and --exercises.
inline bool is_long_run() { return std::getenv("BYHAND_LONG") != nullptr; }

/// Whether a lesson computes for a minute or more, and this is not the long run.
inline bool takes_too_long(std::string_view slug) {
  return !is_long_run() && (slug.starts_with("08") || slug.starts_with("09"));
}

/// Whether the i-th of many is tried: every one in the long run, else each `of`-th, from one on that BYHAND_DRAWN
/// says, which ./tests/run takes from the last commit.
inline bool is_drawn(std::size_t i, std::size_t of) {
  const char* const drawn = std::getenv("BYHAND_DRAWN");
  return is_long_run() || (i + (drawn ? std::strtoul(drawn, nullptr, 10) : 0)) % of == 0;
}

}  // namespace byhand::tests
