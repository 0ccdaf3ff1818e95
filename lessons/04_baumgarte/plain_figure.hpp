#pragma once

#include <functional>

#include "renderer/chart.hpp"

namespace byhand::baumgarte {

/// plain_bias, or what a reader made of it.
using Bias = std::function<double(double C, double beta, double h)>;

/// What is left of an error of 10 cm after each step of h with JV = −b. A reader's bias stands beside this
/// lesson's own, which is dashed.
renderer::Chart chart_of(const Bias& bias);
renderer::Chart chart_beside_ours(const Bias& readers);

}  // namespace byhand::baumgarte
