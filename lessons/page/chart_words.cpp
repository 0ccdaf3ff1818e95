#include "lessons/page/chart_words.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "lessons/page/rounding.hpp"
#include "lessons/page/words.hpp"

namespace byhand::course {
namespace {

using renderer::Chart;
using renderer::Curve;
using renderer::HeatMap;

std::string point(const Curve& curve, size_t i, double size) {
  return fmt::format("({}, {})", number(curve.x[i], 3), number(without_rounding(curve.y[i], size), 3));
}

std::string words_of(const Curve& curve) {
  std::vector<size_t> finite;
  for (size_t i = 0; i < curve.y.size(); ++i)
    if (std::isfinite(curve.x[i]) && std::isfinite(curve.y[i])) finite.push_back(i);
  const std::string name = curve.label.empty() ? "a curve" : curve.label;
  if (finite.empty()) return fmt::format("- {}: no finite values\n", name);
  const auto [low, high] = std::minmax_element(finite.begin(), finite.end(),
                                               [&](size_t a, size_t b) { return curve.y[a] < curve.y[b]; });
  const double size = std::max(std::abs(curve.y[*low]), std::abs(curve.y[*high]));
  const auto at = [&](size_t i) { return point(curve, i, size); };
  const size_t failed = curve.y.size() - finite.size();
  return fmt::format("- {}: from {} to {}, lowest at {}, highest at {}{}\n", name, at(finite.front()),
                     at(finite.back()), at(*low), at(*high),
                     failed ? "; " + several(static_cast<long>(failed), "point") + " without a finite value" : "");
}

std::string words_of(const HeatMap& map) {
  std::vector<double> finite;
  for (const double value : map.values)
    if (std::isfinite(value)) finite.push_back(value);
  if (finite.empty()) return fmt::format("- {}: no finite values\n", map.label);
  if (map.classes.empty()) {
    const auto [low, high] = std::minmax_element(finite.begin(), finite.end());
    return fmt::format("- {}: from {} to {} over {} cells\n", map.label, number(*low, 3), number(*high, 3),
                       map.values.size());
  }
  std::string words;
  for (const auto& [name, cells] : cells_of_classes(map))
    words += fmt::format("- {}: {}\n", name, several(cells, "cell"));
  return words;
}

std::string axis(const renderer::Axis& axis, const std::string& otherwise) {
  return axis.label.empty() ? otherwise : axis.label;
}

}  // namespace

std::vector<std::pair<std::string, long>> cells_of_classes(const HeatMap& map) {
  std::vector<std::pair<std::string, long>> all;
  for (size_t i = 0; i < map.classes.size(); ++i)
    if (const long cells = std::count(map.values.begin(), map.values.end(), static_cast<double>(i)))
      all.emplace_back(map.classes[i].name, cells);
  return all;
}

std::string chart_in_words(const Chart& chart) {
  std::string words = chart.title.empty() ? "" : chart.title + ". ";
  words += fmt::format("A chart of {} over {}.\n", axis(chart.y, "values"), axis(chart.x, "their names"));
  for (const Curve& curve : chart.curves)
    if (!curve.label.empty() || !curve.x.empty()) words += words_of(curve);
  if (chart.heat_map) words += words_of(*chart.heat_map);
  for (const auto& bars : chart.bars)
    for (size_t i = 0; i < bars.values.size() && i < chart.bar_names.size(); ++i)
      words += fmt::format("- {}{}{}: {}\n", chart.bar_names[i], bars.label.empty() ? "" : ", ", bars.label,
                           number(bars.values[i], 3));
  for (const auto& line : chart.references)
    if (!line.label.empty()) words += fmt::format("- a line at {}: {}\n", number(line.value, 3), line.label);
  for (const auto& note : chart.annotations)
    words += fmt::format("- {} at ({}, {})\n", note.text, number(note.x, 3), number(note.y, 3));
  return words;
}

}  // namespace byhand::course
