#include "lessons/05_contact/plain_figure.hpp"

#include <utility>

#include "lessons/05_contact/plain_clamp.hpp"
#include "lessons/pictures/plain_chart.hpp"

namespace byhand::contact {
namespace {

constexpr auto curve_style = renderer::CurveStyle::line_and_markers;

std::vector<renderer::Curve> curves_of(const Change& change) {
  constexpr double s = 0.6;  // 3w²/(w² + 1) for w = ½
  const auto lambdas = plain_sweeps(change, s, 8);
  std::vector<renderer::Curve> curves;
  for (std::size_t row = 0; row < 2; ++row) {
    renderer::Curve curve{.label = row == 0 ? "first row" : "second row", .x = {0}, .y = {0}};
    for (std::size_t i = 0; i < lambdas.size(); ++i) {
      curve.x.push_back(static_cast<double>(i + 1));
      curve.y.push_back(lambdas[i][row]);
    }
    curves.push_back(std::move(curve));
  }
  return curves;
}

renderer::Chart empty_chart() {
  renderer::Chart chart;
  chart.x.label = "sweep";
  chart.y.label = "λ (mgh)";
  chart.y.range = {{0, 1}};
  chart.references.push_back({.value = 0.5, .label = "half the weight"});
  return chart;
}

}  // namespace

std::vector<std::array<double, 2>> plain_sweeps(const Change& change, double s, int sweeps) {
  std::array<double, 2> lambda{};
  std::vector<std::array<double, 2>> all;
  for (int i = 0; i < sweeps; ++i) {
    for (std::size_t row = 0; row < 2; ++row) {
      const double JV = -1 + (1 + s) * lambda[row] + (1 - s) * lambda[1 - row];  // [gh]
      lambda[row] += change(JV, 1 + s, lambda[row]);
    }
    all.push_back(lambda);
  }
  return all;
}

renderer::Chart chart_of(const Change& change) {
  return pictures::with_curves(empty_chart(), curves_of(change), curve_style);
}

renderer::Chart chart_beside_ours(const Change& readers) {
  return pictures::beside_ours(empty_chart(), curves_of(plain_change), curves_of(readers), curve_style);
}

}  // namespace byhand::contact
