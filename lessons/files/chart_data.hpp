#pragma once

#include <string>

#include "renderer/chart.hpp"

namespace byhand::course {

/// The data of a chart as comma-separated values. The header row has the labels of the axes, with units. Curves
/// with the same x share its column. Gaps are empty cells, failed runs "inf".
std::string csv(const renderer::Chart& chart);

}  // namespace byhand::course
