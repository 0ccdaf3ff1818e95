#pragma once

#include <string>

#include "renderer/chart.hpp"

namespace byhand::tutor {

/// A chart in Markdown sentences, for screen readers: its axes, and of each curve both ends and extremes.
std::string chart_in_words(const renderer::Chart& chart);

}  // namespace byhand::tutor
