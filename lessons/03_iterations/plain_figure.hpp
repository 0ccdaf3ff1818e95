#pragma once

#include <functional>
#include <span>

#include "renderer/chart.hpp"

namespace byhand::iterations {

/// plain_sweep, or what a reader made of it.
using Sweep = std::function<void(double L, double m, std::span<double> v, std::span<double> lambda)>;

/// How fast the fastest bob of short chains still moves after each sweep, as a share of the speed with which all
/// begin to fall. A reader's sweep stands beside this lesson's own, which is dashed.
renderer::Chart chart_of(const Sweep& sweep);
renderer::Chart chart_beside_ours(const Sweep& readers);

}  // namespace byhand::iterations
