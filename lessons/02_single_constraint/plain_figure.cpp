#include "lessons/02_single_constraint/plain_figure.hpp"

#include <cmath>
#include <optional>
#include <vector>

#include "lessons/02_single_constraint/plain_step.hpp"
#include "lessons/pictures/plain_chart.hpp"

namespace byhand::single_constraint {
namespace {

constexpr auto curve_style = renderer::CurveStyle::line;

std::vector<renderer::Curve> curves_of(const Step& step, const Bob& bob = {}) {
  const auto [L, m, release, h] = bob;
  constexpr double g = 9.81;
  const auto steps = static_cast<int>(std::lround(10 / h));
  Vec2 x{L * std::sin(release), -L * std::cos(release)}, v;
  const auto energy = [&, m = m] { return m * (dot(v, v) / 2 + g * x.y); };
  const double first = energy();
  renderer::Curve drift{.label = "C/L²"}, change{.label = "ΔE/(m·g·L)"};
  for (int done = 0; done <= steps; ++done) {
    for (renderer::Curve* curve : {&drift, &change}) curve->x.push_back(done * h);
    drift.y.push_back((dot(x, x) - L * L) / 2 / (L * L));
    change.y.push_back((energy() - first) / (m * g * L));
    step(x, v, m, {0, -g}, h);
  }
  return {drift, change};
}

renderer::Chart empty_chart(std::optional<std::pair<double, double>> range = {}) {
  renderer::Chart chart;
  chart.x.label = "time (s)";
  chart.y.label = "C/L², ΔE/(m·g·L)";
  chart.y.range = range;
  return chart;
}

}  // namespace

renderer::Chart chart_of(const Step& step, const Bob& bob) {
  std::vector<renderer::Curve> curves = curves_of(step, bob);
  curves[0].colour = renderer::palette::error;
  curves[1].colour = renderer::palette::series(5);
  return pictures::with_curves(empty_chart(), std::move(curves), curve_style);
}

renderer::Chart chart_beside_ours(const Step& readers) {
  return pictures::beside_ours(empty_chart(std::pair{-1.0, 1.0}), curves_of(plain_step), curves_of(readers),
                               curve_style);
}

}  // namespace byhand::single_constraint
