#include "lessons/03_iterations/plain_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lessons/03_iterations/plain_sweep.hpp"

namespace byhand::iterations {
namespace {

/// Of the fastest; NaN for a chain that rests, which a logarithm does not show.
double speed_of(const std::vector<double>& v) {
  double most = 0;
  for (const double speed : v)
    most = std::isfinite(speed) ? std::max(most, std::abs(speed)) : std::numeric_limits<double>::infinity();
  return most > 0 ? most : std::numeric_limits<double>::quiet_NaN();
}

void add_curves(renderer::Chart& chart, const Sweep& sweep, const std::string& whose, renderer::CurveStyle style) {
  constexpr int sweeps = 20;
  for (const int links : {2, 5, 10}) {
    renderer::Curve curve{.label = std::to_string(links) + " links" + whose, .style = style};
    std::vector<double> v(static_cast<std::size_t>(links), 1), lambda(v.size(), 0);
    for (int done = 0; done <= sweeps; ++done) {
      curve.x.push_back(done);
      curve.y.push_back(speed_of(v));
      sweep(0.5, 2, v, lambda);
    }
    chart.curves.push_back(std::move(curve));
  }
}

renderer::Chart empty_chart() {
  renderer::Chart chart;
  chart.x.label = "sweeps";
  chart.y.label = "speed of the fastest bob (gh)";
  chart.y.scale = renderer::Scale::logarithmic;
  chart.y.range = {{1e-4, 10}};
  return chart;
}

}  // namespace

renderer::Chart chart_of(const Sweep& sweep) {
  renderer::Chart chart = empty_chart();
  add_curves(chart, sweep, "", renderer::CurveStyle::line_and_markers);
  return chart;
}

renderer::Chart chart_beside_ours(const Sweep& readers) {
  renderer::Chart chart = empty_chart();
  add_curves(chart, plain_sweep, "", renderer::CurveStyle::theory);
  add_curves(chart, readers, ", yours", renderer::CurveStyle::line_and_markers);
  return chart;
}

}  // namespace byhand::iterations
