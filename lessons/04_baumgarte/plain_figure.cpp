#include "lessons/04_baumgarte/plain_figure.hpp"

#include <fmt/format.h>

#include <string>
#include <utility>

#include "lessons/04_baumgarte/plain_bias.hpp"

namespace byhand::baumgarte {
namespace {

void add_curves(renderer::Chart& chart, const Bias& bias, const std::string& whose, renderer::CurveStyle style) {
  constexpr double h = 1.0 / 60;
  constexpr int steps = 10;
  for (const double beta : {0.2, 0.6, 1.5}) {
    renderer::Curve curve{.label = fmt::format("β = {}{}", beta, whose), .style = style};
    double C = 0.1;
    for (int done = 0; done <= steps; ++done) {
      curve.x.push_back(done);
      curve.y.push_back(100 * C);
      C -= h * bias(C, beta, h);  // one step at the rate JV = −b
    }
    chart.curves.push_back(std::move(curve));
  }
}

renderer::Chart empty_chart() {
  renderer::Chart chart;
  chart.x.label = "steps";
  chart.y.label = "C (cm)";
  chart.y.range = {{-12, 12}};
  return chart;
}

}  // namespace

renderer::Chart chart_of(const Bias& bias) {
  renderer::Chart chart = empty_chart();
  add_curves(chart, bias, "", renderer::CurveStyle::line_and_markers);
  return chart;
}

renderer::Chart chart_beside_ours(const Bias& readers) {
  renderer::Chart chart = empty_chart();
  add_curves(chart, plain_bias, "", renderer::CurveStyle::theory);
  add_curves(chart, readers, ", yours", renderer::CurveStyle::line_and_markers);
  return chart;
}

}  // namespace byhand::baumgarte
