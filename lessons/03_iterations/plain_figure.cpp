#include "lessons/03_iterations/plain_figure.hpp"

#include <algorithm>
#include <cmath>
#include <limits>
#include <string>
#include <vector>

#include "lessons/03_iterations/plain_sweep.hpp"
#include "lessons/pictures/plain_chart.hpp"

namespace byhand::iterations {
namespace {

constexpr auto curve_style = renderer::CurveStyle::line_and_markers;

/// The largest row error, how fast a link is getting longer; NaN where there is none, which a logarithm does not
/// show.
double error_of(const std::vector<double>& v) {
  double most = 0, above = 0;
  for (const double speed : v) {
    const double error = std::abs(speed - above);
    most = std::isfinite(error) ? std::max(most, error) : std::numeric_limits<double>::infinity();
    above = speed;
  }
  return most > 0 ? most : std::numeric_limits<double>::quiet_NaN();
}

std::vector<renderer::Curve> curves_of(const Sweep& sweep) {
  constexpr int sweeps = 20;
  std::vector<renderer::Curve> curves;
  for (const int links : {2, 5, 10}) {
    renderer::Curve curve{.label = std::to_string(links) + " links"};
    std::vector<double> v(static_cast<std::size_t>(links), 1), lambda(v.size(), 0);
    for (int done = 0; done <= sweeps; ++done) {
      curve.x.push_back(done);
      curve.y.push_back(error_of(v));
      sweep(0.5, 2, v, lambda);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

renderer::Chart empty_chart(double highest) {
  renderer::Chart chart;
  chart.x.label = "sweeps";
  chart.y.label = "largest error (gh)";
  chart.y.scale = renderer::Scale::logarithmic;
  chart.y.range = {{3e-7, highest}};
  return chart;
}

}  // namespace

renderer::Chart chart_of(const Sweep& sweep) {
  return pictures::with_curves(empty_chart(1.5), curves_of(sweep), curve_style);
}

renderer::Chart chart_beside_ours(const Sweep& readers) {
  return pictures::beside_ours(empty_chart(10), curves_of(plain_sweep), curves_of(readers), curve_style);
}

}  // namespace byhand::iterations
