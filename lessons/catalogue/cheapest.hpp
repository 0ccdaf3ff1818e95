#pragma once

#include <limits>
#include <span>

#include "lessons/catalogue/tuning.hpp"
#include "lessons/catalogue/wish.hpp"

// The search for one method's choices that reach a wish at the least cost.
namespace byhand {

/// The cheapest run of one method within the limits from all starts, at least one, that costs at most `bound` from
/// the first, or what came nearest until `most` instructions were spent. What reaches them from the first is held
/// against the others, the last first. `known` are runs of earlier searches with the same limits, by start.
Candidate cheapest(std::span<const Problem> starts, const Family& family, const Wish& wish, double bound,
                   Spent* spent = nullptr, double most = std::numeric_limits<double>::infinity(),
                   std::vector<Known>* known = nullptr);

/// How a search watches a run that may cost `bound` a frame: as long as screening() says, and until an error is
/// far beyond its limit.
Watch watch_of(const Problem& problem, const Wish& wish, double bound);

}  // namespace byhand
