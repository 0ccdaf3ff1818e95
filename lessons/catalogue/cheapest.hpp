#pragma once

#include <limits>

#include "lessons/catalogue/tuning.hpp"
#include "lessons/catalogue/wish.hpp"

// The search for one method's choices that reach a wish at the least cost.
namespace byhand {

/// The cheapest run of one method within the limits that costs at most `bound`, or what came nearest until `most`
/// instructions were spent. `known` are runs of earlier searches with the same limits.
Candidate cheapest(const Problem& problem, const Family& family, const Wish& wish, double bound,
                   Spent* spent = nullptr, double most = std::numeric_limits<double>::infinity(),
                   Known* known = nullptr);

}  // namespace byhand
