#pragma once

#include <string>
#include <utility>
#include <vector>

#include "renderer/chart.hpp"

// Charts of a lesson's plain algorithm, which its reader may change in the page.
namespace byhand::pictures {

inline renderer::Chart with_curves(renderer::Chart chart, std::vector<renderer::Curve> curves,
                                   renderer::CurveStyle style, const std::string& whose = "") {
  for (renderer::Curve& curve : curves) {
    curve.label += whose;
    curve.style = style;
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

/// The lesson's own curves, dashed, and beside them those of what a reader made of it.
inline renderer::Chart beside_ours(renderer::Chart empty, std::vector<renderer::Curve> ours,
                                   std::vector<renderer::Curve> readers, renderer::CurveStyle style) {
  return with_curves(with_curves(std::move(empty), std::move(ours), renderer::CurveStyle::theory),
                     std::move(readers), style, ", yours");
}

}  // namespace byhand::pictures
