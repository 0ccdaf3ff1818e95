#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/chart.hpp"

namespace byhand::course {

/// A chart in Markdown sentences, for screen readers: its axes, and of each curve both ends and extremes.
std::string chart_in_words(const renderer::Chart& chart);

/// How many cells of a map are of each of its classes; those without a cell are left out.
std::vector<std::pair<std::string, long>> cells_of_classes(const renderer::HeatMap& map);

}  // namespace byhand::course
