#pragma once

#include <any>

namespace byhand {

/// The W in `kept`; a new one where it holds nothing or something else.
template <class W>
W& kept_as(std::any& kept) {
  if (W* found = std::any_cast<W>(&kept)) return *found;
  return kept.emplace<W>();
}

}  // namespace byhand
