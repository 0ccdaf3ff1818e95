#pragma once

#include <string>

#include "lessons/terminal/typeset.hpp"
#include "renderer/chart.hpp"

namespace byhand::course {

/// The chart in characters, `style.width` columns wide and about 20 lines high; in words if `style.plain`.
std::string text_chart(const renderer::Chart& chart, const Style& style);

}  // namespace byhand::course
