#pragma once

#include <array>
#include <functional>
#include <vector>

#include "renderer/chart.hpp"

namespace byhand::contact {

/// plain_change, or what a reader made of it.
using Change = std::function<double(double JV, double K, double lambda)>;

/// λ of the two rows after each of `sweeps` sweeps [m·g·h], of a box that stands on two corners; s = r²m/I of a
/// corner.
std::vector<std::array<double, 2>> plain_sweeps(const Change& change, double s, int sweeps);

/// The same for a box half as wide as it is high. A reader's change stands beside this lesson's own, which is
/// dashed.
renderer::Chart chart_of(const Change& change);
renderer::Chart chart_beside_ours(const Change& readers);

}  // namespace byhand::contact
