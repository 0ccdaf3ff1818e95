#include "lessons/files/chart_data.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <vector>

namespace byhand::course {
namespace {

using renderer::Chart;
using renderer::Curve;

struct Column {
  std::string header;
  std::vector<std::string> cells;
};

std::string quoted(const std::string& cell) {
  if (cell.find_first_of(",\"\n") == std::string::npos) return cell;
  std::string doubled;
  for (const char c : cell) doubled += c == '"' ? "\"\"" : std::string(1, c);
  return '"' + doubled + '"';
}

Column column(std::string header, const std::vector<double>& values) {
  Column made{std::move(header), {}};
  // The last digits would tell one processor's sine and exponential from another's.
  for (const double value : values) made.cells.push_back(std::isnan(value) ? "" : fmt::format("{:.12g}", value));
  return made;
}

std::string joined(const std::string& a, const std::string& b) {
  return a.empty() || b.empty() ? a + b : a + ": " + b;
}

void add_heat_map(const Chart& chart, std::vector<Column>& columns) {
  std::vector<double> x, y;
  for (const double row : chart.heat_map->y) {
    for (const double at : chart.heat_map->x) {
      x.push_back(at);
      y.push_back(row);
    }
  }
  columns.push_back(column(chart.x.label, x));
  columns.push_back(column(chart.y.label, y));
  columns.push_back(column(chart.heat_map->label, chart.heat_map->values));
  if (chart.heat_map->classes.empty()) return;
  for (std::size_t i = 0; i < chart.heat_map->values.size(); ++i)
    columns.back().cells[i] = class_name(*chart.heat_map, chart.heat_map->values[i]);
}

void add_bars(const Chart& chart, std::vector<Column>& columns) {
  columns.push_back({chart.x.label, chart.bar_names});
  for (const auto& bars : chart.bars) columns.push_back(column(joined(bars.label, chart.y.label), bars.values));
}

void add_curves(const Chart& chart, std::vector<Column>& columns) {
  std::vector<Curve> curves = chart.curves;
  std::erase_if(curves, [](const Curve& curve) { return curve.label.empty() && curve.x.empty(); });
  const bool shared =
      std::all_of(curves.begin(), curves.end(), [&](const Curve& curve) { return curve.x == curves.front().x; });
  for (const Curve& curve : curves) {
    if (!shared)
      columns.push_back(column(joined(curve.label, chart.x.label), curve.x));
    else if (&curve == &curves.front())
      columns.push_back(column(chart.x.label, curve.x));
    columns.push_back(column(joined(curve.label, chart.y.label), curve.y));
    const auto& names = curve.point_names.empty() ? curve.point_labels : curve.point_names;
    if (!names.empty()) columns.push_back({joined(curve.label, "label"), names});
  }
}

}  // namespace

std::string csv(const Chart& chart) {
  std::vector<Column> columns;
  if (chart.heat_map) add_heat_map(chart, columns);
  if (!chart.bars.empty()) add_bars(chart, columns);
  add_curves(chart, columns);

  size_t rows = 0;
  for (const Column& c : columns) rows = std::max(rows, c.cells.size());
  std::string text;
  for (const Column& c : columns) text += (&c == &columns.front() ? "" : ",") + quoted(c.header);
  text += "\n";
  for (size_t row = 0; row < rows; ++row) {
    for (const Column& c : columns)
      text += (&c == &columns.front() ? "" : ",") + (row < c.cells.size() ? quoted(c.cells[row]) : "");
    text += "\n";
  }
  return text;
}

}  // namespace byhand::course
