#include "lessons/04_baumgarte/plain_figure.hpp"

#include <fmt/format.h>

#include <initializer_list>
#include <utility>
#include <vector>

#include "lessons/04_baumgarte/plain_bias.hpp"
#include "lessons/pictures/plain_chart.hpp"

namespace byhand::baumgarte {
namespace {

constexpr auto curve_style = renderer::CurveStyle::line_and_markers;

std::vector<renderer::Curve> curves_of(const Bias& bias, std::initializer_list<double> betas) {
  constexpr double h = 1.0 / 60;
  constexpr int steps = 10;
  std::vector<renderer::Curve> curves;
  for (const double beta : betas) {
    renderer::Curve curve{.label = fmt::format("β = {}", beta)};
    double C = 0.1;
    for (int done = 0; done <= steps; ++done) {
      curve.x.push_back(done);
      curve.y.push_back(100 * C);
      C -= h * bias(C, beta, h);  // one step at the rate JV = −b
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

renderer::Chart empty_chart(double lowest) {
  renderer::Chart chart;
  chart.x.label = "steps";
  chart.y.label = "C (cm)";
  chart.y.range = {{lowest, 12}};
  return chart;
}

}  // namespace

renderer::Chart chart_of(const Bias& bias) {
  return pictures::with_curves(empty_chart(-0.5), curves_of(bias, {0.1, 0.2, 0.6}), curve_style);
}

renderer::Chart chart_beside_ours(const Bias& readers) {
  const auto betas = {0.2, 0.6, 1.5};  // the last one overshoots
  return pictures::beside_ours(empty_chart(-12), curves_of(plain_bias, betas), curves_of(readers, betas),
                               curve_style);
}

}  // namespace byhand::baumgarte
