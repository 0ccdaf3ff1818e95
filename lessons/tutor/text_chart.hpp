#pragma once

#include <string>

#include "lessons/tutor/typeset.hpp"
#include "renderer/chart.hpp"

namespace byhand::tutor {

/// The chart in characters, at most 80 columns (or `style.width`) wide and about 20 lines high.
std::string text_chart(const renderer::Chart& chart, const Style& style);

}  // namespace byhand::tutor
