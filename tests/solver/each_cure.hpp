#pragma once

#include <utility>
#include <vector>

#include "solver/step.hpp"

namespace byhand::tests {

/// Each cure of drift as it is by default, and the soft one whose rows stay as they were.
inline std::vector<DriftCure> each_cure() {
  return []<std::size_t... I>(std::index_sequence<I...>) {
    return std::vector<DriftCure>{std::variant_alternative_t<I, DriftCure>{}...,
                                  SoftConstraints{.refresh = false}};
  }
  (std::make_index_sequence<std::variant_size_v<DriftCure>>());
}

}  // namespace byhand::tests
