#pragma once

#include <string>

#include "renderer/chart.hpp"

namespace byhand::tutor {

/// What a chart shows, as comma-separated values. The header row names quantities with their units as the
/// axes do. Curves that share x share its column; gaps are empty, failed runs "inf".
std::string csv(const renderer::Chart& chart);

}  // namespace byhand::tutor
