#include "lessons/02_single_constraint/plain_figure.hpp"

#include <string>
#include <utility>

#include "lessons/02_single_constraint/plain_step.hpp"

namespace byhand::single_constraint {
namespace {

/// Of a bob of 2 kg that is let go at 53° on a rod of 1 m.
void add_curves(renderer::Chart& chart, const Step& step, const std::string& whose, renderer::CurveStyle style) {
  constexpr double L = 1, m = 2, g = 9.81, h = time_step;
  constexpr int steps = 600;
  Vec2 x{0.8 * L, -0.6 * L}, v;
  const auto energy = [&] { return m * (dot(v, v) / 2 + g * x.y); };
  const double first = energy();
  renderer::Curve drift{.label = "C/L²" + whose, .style = style},
      change{.label = "ΔE/(m·g·L)" + whose, .style = style};
  for (int done = 0; done <= steps; ++done) {
    for (renderer::Curve* curve : {&drift, &change}) curve->x.push_back(done * h);
    drift.y.push_back((dot(x, x) - L * L) / 2 / (L * L));
    change.y.push_back((energy() - first) / (m * g * L));
    step(x, v, m, {0, -g}, h);
  }
  chart.curves.push_back(std::move(drift));
  chart.curves.push_back(std::move(change));
}

renderer::Chart empty_chart() {
  renderer::Chart chart;
  chart.x.label = "time (s)";
  chart.y.label = "C/L², ΔE/(m·g·L)";
  chart.y.range = {{-1, 1}};
  return chart;
}

}  // namespace

renderer::Chart chart_of(const Step& step) {
  renderer::Chart chart = empty_chart();
  add_curves(chart, step, "", renderer::CurveStyle::line);
  return chart;
}

renderer::Chart chart_beside_ours(const Step& readers) {
  renderer::Chart chart = empty_chart();
  add_curves(chart, plain_step, "", renderer::CurveStyle::theory);
  add_curves(chart, readers, ", yours", renderer::CurveStyle::line);
  return chart;
}

}  // namespace byhand::single_constraint
