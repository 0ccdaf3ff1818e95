#pragma once

#include <cstdlib>
#include <string_view>

namespace byhand::tests {

/// Whether a lesson computes for a minute or more, and this is not the long run: ./tests/run --settings.
inline bool takes_too_long(std::string_view slug) {
  return !std::getenv("BYHAND_LONG") && (slug.starts_with("08") || slug.starts_with("09"));
}

}  // namespace byhand::tests
