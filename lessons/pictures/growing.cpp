#include "lessons/pictures/growing.hpp"

namespace byhand::pictures {

renderer::Chart grown_to(renderer::Chart whole, double x) {
  const renderer::ChartRanges all = ranges(whole);
  whole.x.range = all.x;
  whole.y.range = all.y;
  for (renderer::Curve& curve : whole.curves) {
    if (curve.style == renderer::CurveStyle::theory) continue;
    std::size_t shown = 0;
    while (shown < curve.x.size() && curve.x[shown] <= x) ++shown;
    curve.x.resize(shown);
    curve.y.resize(shown);
    if (curve.point_labels.size() > shown) curve.point_labels.resize(shown);
    if (shown > 0) whole.annotations.push_back({curve.x.back(), curve.y.back(), ""});
  }
  return whole;
}

}  // namespace byhand::pictures
