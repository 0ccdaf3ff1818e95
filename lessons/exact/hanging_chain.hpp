#pragma once

#include <span>
#include <vector>

namespace byhand {

/// Tension in each joint of a chain at rest [N], top first: joint i carries the weight of mass i and all
/// below it. `masses` [kg] go from the top down; `gravity` in m/s². Throws std::invalid_argument unless all
/// are positive.
std::vector<double> hanging_chain_tensions(std::span<const double> masses, double gravity);

}  // namespace byhand
