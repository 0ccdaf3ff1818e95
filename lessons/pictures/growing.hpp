#pragma once

#include "renderer/chart.hpp"

namespace byhand::pictures {

/// The chart as it has grown by `x`: its axes stay those of the whole, its curves end there (theory stays), and a
/// dot rides on each end. For the chart beside a moving scene.
renderer::Chart grown_to(renderer::Chart whole, double x);

}  // namespace byhand::pictures
