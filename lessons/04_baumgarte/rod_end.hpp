#pragma once

#include "lessons/04_baumgarte/setting.hpp"

namespace byhand::baumgarte {

/// The lower end of a hanging rod, seen close: the bob `error` [m] below the dashed line where it belongs, with
/// `reach` [m] to be seen on both sides of that line and `words` beneath.
void draw_rod_end(renderer::Canvas& canvas, const renderer::Rectangle& frame, double error, double reach,
                  const std::string& words);

}  // namespace byhand::baumgarte
