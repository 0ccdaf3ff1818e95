#include "lessons/terminal/text_chart.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <limits>
#include <vector>

#include "lessons/page/chart_words.hpp"
#include "lessons/page/words.hpp"
#include "lessons/terminal/braille.hpp"
#include "lessons/terminal/terminal_picture.hpp"
#include "renderer/ticks.hpp"

namespace byhand::course {
namespace {

using renderer::Axis;
using renderer::Chart;
using renderer::Curve;
using renderer::CurveStyle;
using renderer::HeatMap;
using renderer::Scale;

constexpr int margin = 10;  // columns for the labels of the vertical axis

constexpr std::array<const char*, 8> marks = {"•", "×", "+", "o", "#", "*", "%", "="};
constexpr std::array<int, 6> mark_colours = {34, 33, 32, 35, 36, 31};
constexpr std::array<const char*, 5> shades = {"·", "░", "▒", "▓", "█"};

/// Maps values of an axis to cells 0 … count−1 (row 0 on top).
class Ruler {
 public:
  Ruler(const Axis& axis, std::pair<double, double> range, int count, bool downwards)
      : scale_(axis.scale),
        low_(on_scale(range.first)),
        high_(on_scale(range.second)),
        count_(count),
        flipped_(axis.reversed != downwards) {}

  /// Cells as a real number; NaN for what the scale cannot show.
  double position(double value) const {
    const double share = (on_scale(value) - low_) / (high_ - low_);
    return (flipped_ ? 1 - share : share) * (count_ - 1);
  }
  int cell(double value) const { return static_cast<int>(std::lround(position(value))); }
  bool shows(double value) const {
    const double at = position(value);
    return at >= -0.5 && at < count_ - 0.5;
  }
  double value(int cell) const {
    const double share = static_cast<double>(cell) / (count_ - 1);
    const double at = low_ + (flipped_ ? 1 - share : share) * (high_ - low_);
    return scale_ == Scale::logarithmic ? std::pow(10, at) : at;
  }
  int count() const { return count_; }

 private:
  double on_scale(double value) const {
    if (scale_ == Scale::linear) return value;
    return value > 0 ? std::log10(value) : std::numeric_limits<double>::quiet_NaN();
  }

  Scale scale_;
  double low_, high_;
  int count_;
  bool flipped_;
};

/// Characters in rows, each with a colour of the terminal (0: its own).
class Grid {
 public:
  Grid(int rows, int columns) : rows_(rows, std::vector<Cell>(columns)) {}

  void put(int row, int column, const char* sign, int colour) {
    const int rows = static_cast<int>(rows_.size()), columns = static_cast<int>(rows_.front().size());
    if (row >= 0 && row < rows && column >= 0 && column < columns) rows_[row][column] = {sign, colour};
  }

  /// One of the 2 × 4 braille dots of a cell; `row` and `column` count cells. A sign in the cell hides it.
  void put_dot(double row, double column, int colour) {
    const int y = static_cast<int>(std::floor(dots_down * (row + 0.5))),
              x = static_cast<int>(std::floor(dots_across * (column + 0.5)));
    const int rows = static_cast<int>(rows_.size()), columns = static_cast<int>(rows_.front().size());
    if (y < 0 || x < 0 || y / dots_down >= rows || x / dots_across >= columns) return;
    Cell& cell = rows_[y / dots_down][x / dots_across];
    cell.dots |= braille_dot(x % dots_across, y % dots_down);
    cell.dot_colour = colour;
  }

  std::string row(int row, const Style& style) const {
    std::string line;
    for (const Cell& cell : rows_[row]) {
      const bool fine = cell.dots && std::string_view(cell.sign) == " ";
      const std::string sign = fine ? braille(cell.dots) : cell.sign;
      const int colour = fine ? cell.dot_colour : cell.colour;
      line += style.colours && colour ? fmt::format("\033[{}m{}\033[0m", colour, sign) : sign;
    }
    return line.erase(line.find_last_not_of(' ') + 1);
  }

 private:
  struct Cell {
    const char* sign = " ";
    int colour = 0;
    unsigned dots = 0;
    int dot_colour = 0;
  };
  std::vector<std::vector<Cell>> rows_;
};

struct Pen {
  const char* sign;
  int colour;
  bool fine = false;  // lines in braille, and the sign on them now and then
};

/// Theory has dots of its own; measurements have a sign and a colour each.
std::vector<Pen> pens(const std::vector<Curve>& curves, const Style& style) {
  std::vector<Pen> all;
  size_t measured = 0;
  for (const Curve& curve : curves) {
    if (curve.style == CurveStyle::theory)
      all.push_back({"·", 0});
    else if (curve.style == CurveStyle::front)
      all.push_back({"░", 33});
    else {
      all.push_back({marks[measured % marks.size()], mark_colours[measured % mark_colours.size()], style.colours});
      ++measured;
    }
  }
  return all;
}

void draw_segment(Grid& grid, const Ruler& x, const Ruler& y, const Curve& curve, size_t i, const Pen& pen) {
  const double x0 = x.position(curve.x[i - 1]), x1 = x.position(curve.x[i]);
  const double y0 = y.position(curve.y[i - 1]), y1 = y.position(curve.y[i]);
  if (!std::isfinite(x0 + x1 + y0 + y1)) return;
  const int samples = std::min(
      4 * (x.count() + y.count()),
      static_cast<int>(std::ceil((pen.fine ? 8 : 2) * std::max(std::abs(x1 - x0), std::abs(y1 - y0)))) + 1);
  for (int k = 0; k <= samples; ++k) {
    const double share = static_cast<double>(k) / samples;
    if (pen.fine) {
      grid.put_dot(y0 + share * (y1 - y0), x0 + share * (x1 - x0), pen.colour);
      continue;
    }
    grid.put(static_cast<int>(std::lround(y0 + share * (y1 - y0))),
             static_cast<int>(std::lround(x0 + share * (x1 - x0))), pen.sign, pen.colour);
  }
}

/// Level from each point to the next, then upright.
void draw_front(Grid& grid, const Ruler& x, const Ruler& y, Curve curve, const Pen& pen) {
  for (size_t i = curve.x.size(); i-- > 1;) {
    curve.x.insert(curve.x.begin() + static_cast<long>(i), curve.x[i]);
    curve.y.insert(curve.y.begin() + static_cast<long>(i), curve.y[i - 1]);
  }
  for (size_t i = 1; i < curve.x.size(); ++i) draw_segment(grid, x, y, curve, i, pen);
}

void draw_curve(Grid& grid, const Ruler& x, const Ruler& y, const Curve& curve, const Pen& pen) {
  if (curve.style == CurveStyle::front) return draw_front(grid, x, y, curve, pen);
  const bool joined = curve.style == CurveStyle::line || curve.style == CurveStyle::line_and_markers ||
                      curve.style == CurveStyle::theory;
  constexpr int signs_apart = 12;  // columns, on a fine line
  int next_sign = 0;
  for (size_t i = 0; i < curve.x.size(); ++i) {
    if (joined && i > 0) draw_segment(grid, x, y, curve, i, pen);
    // A run that failed stands at the edge.
    if (std::isinf(curve.y[i]) && x.shows(curve.x[i]))
      grid.put(curve.y[i] > 0 ? 0 : y.count() - 1, x.cell(curve.x[i]), "✗", 31);
    if (std::isinf(curve.x[i]) && y.shows(curve.y[i]))
      grid.put(y.cell(curve.y[i]), curve.x[i] > 0 ? x.count() - 1 : 0, "✗", 31);
    if (!x.shows(curve.x[i]) || !std::isfinite(y.position(curve.y[i]))) continue;
    if (curve.style == CurveStyle::stems) {
      const int from = y.cell(0), to = y.cell(curve.y[i]);
      for (int row = std::min(from, to); row <= std::max(from, to); ++row)
        grid.put(row, x.cell(curve.x[i]), "│", pen.colour);
    }
    if (pen.fine && curve.style == CurveStyle::line && i > 0) {
      const bool has_come = std::abs(x.cell(curve.x[i]) - x.cell(curve.x[i - 1])) > 0 || i % 64 == 0;
      if (!has_come || x.cell(curve.x[i]) < next_sign) continue;
    }
    next_sign = x.cell(curve.x[i]) + signs_apart;
    grid.put(y.cell(curve.y[i]), x.cell(curve.x[i]), pen.sign, pen.colour);
  }
}

/// 0 … 1 within the values of the map; of a diverging one, the size against the largest.
class Shading {
 public:
  explicit Shading(const HeatMap& map) : map_(map) {
    for (const double value : map.values) {
      const double at = on_scale(value);
      if (!std::isfinite(at)) continue;
      low_ = std::min(low_, at);
      high_ = std::max(high_, at);
    }
    if (!map.classes.empty()) {
      low_ = 0;
      high_ = static_cast<double>(map.classes.size() - 1);
    }
    if (map.range) {
      low_ = on_scale(map.range->first);
      high_ = on_scale(map.range->second);
    }
    if (map.diverging) low_ = 0;
  }

  Pen pen(double value) const {
    if (std::isnan(value)) return {" ", 0};
    if (std::isinf(value)) return {"✗", 31};
    const double share = high_ > low_ ? (on_scale(value) - low_) / (high_ - low_) : 0;
    const auto shade = static_cast<size_t>(std::lround(std::clamp(share, 0.0, 1.0) * (shades.size() - 1)));
    return {shades[shade], map_.diverging && value < 0 ? 34 : 33};
  }

  std::string key() const {
    if (!map_.classes.empty()) {
      std::string names;
      for (std::size_t i = 0; i < map_.classes.size(); ++i)
        if (!map_.classes[i].name.empty())
          names += fmt::format("{}{} {}", names.empty() ? "" : ", ", pen(static_cast<double>(i)).sign,
                               map_.classes[i].name);
      return map_.label + ": " + names;
    }
    const auto value = [&](double at) {
      return number(map_.scale == Scale::logarithmic ? std::pow(10, at) : at, 3);
    };
    const std::string ends =
        fmt::format("{} {} … {} {}", shades.front(), value(low_), shades.back(), value(high_));
    return map_.label + ": " + ends + (map_.diverging ? " (of either sign)" : "");
  }

 private:
  double on_scale(double value) const {
    const double at = map_.diverging ? std::abs(value) : value;
    return map_.scale == Scale::logarithmic ? std::log10(at) : at;
  }

  const HeatMap& map_;
  double low_ = std::numeric_limits<double>::infinity(), high_ = -std::numeric_limits<double>::infinity();
};

size_t nearest(const std::vector<double>& centres, double value) {
  const auto closer = [&](double a, double b) { return std::abs(a - value) < std::abs(b - value); };
  return static_cast<size_t>(std::min_element(centres.begin(), centres.end(), closer) - centres.begin());
}

void draw_heat_map(Grid& grid, const Ruler& x, const Ruler& y, const HeatMap& map) {
  const Shading shading(map);
  for (int row = 0; row < y.count(); ++row) {
    for (int column = 0; column < x.count(); ++column) {
      const size_t from = nearest(map.y, y.value(row)) * map.x.size() + nearest(map.x, x.value(column));
      const Pen pen = shading.pen(map.values[from]);
      grid.put(row, column, pen.sign, pen.colour);
    }
  }
}

struct AxisTicks {
  std::vector<renderer::Tick> ticks;
  std::string label;
};

/// So that a chart with its axis, legend and caption fits on the terminal.
int plot_height(const Style& style) { return std::clamp(style.rows - 12, 6, 16); }

AxisTicks ticks_of(const Axis& axis, std::pair<double, double> range, int most) {
  if (!axis.ticks.empty()) return {axis.ticks, axis.label};
  const auto found = renderer::ticks(axis.scale, range.first, range.second, most);
  return {found.major, axis.label + (found.exponent ? fmt::format(" · 1e{}", found.exponent) : "")};
}

std::string horizontal_axis(const Ruler& x, const AxisTicks& axis, int columns) {
  std::string line = std::string(margin, ' ') + "└", labels = std::string(margin + 1, ' ');
  std::vector<bool> ticked(static_cast<size_t>(columns), false);
  int column = margin + 1;
  // Ticks of a reversed axis come from right to left.
  auto ticks = axis.ticks;
  std::sort(ticks.begin(), ticks.end(),
            [&](const auto& a, const auto& b) { return x.position(a.value) < x.position(b.value); });
  for (const auto& tick : ticks) {
    if (tick.label.empty() || !x.shows(tick.value)) continue;
    const int at = x.cell(tick.value);
    ticked[static_cast<size_t>(at)] = true;
    const int start = std::min(margin + 1 + at - display_width(tick.label) / 2,
                               margin + 1 + columns - display_width(tick.label));
    if (start < column) continue;
    labels = padded(labels, start) + tick.label;
    column = start + display_width(tick.label) + 1;
  }
  for (const bool tick : ticked) line += tick ? "┬" : "─";
  const int before = margin + 1 + (columns - display_width(axis.label)) / 2;
  return line + "\n" + labels + "\n" + padded("", before) + axis.label + "\n";
}

std::string plot(const Chart& chart, const Style& style) {
  const auto ranges = renderer::ranges(chart);
  const int columns = style.width - margin - 2, plot_rows = plot_height(style);
  const Ruler x(chart.x, ranges.x, columns, false), y(chart.y, ranges.y, plot_rows, true);
  const AxisTicks x_ticks = ticks_of(chart.x, ranges.x, 7), y_ticks = ticks_of(chart.y, ranges.y, 5);

  Grid grid(plot_rows, columns);
  if (chart.heat_map) draw_heat_map(grid, x, y, *chart.heat_map);
  for (const auto& line : chart.references) {
    const bool level = line.axis == renderer::Reference::Across::y;
    if (!(level ? y : x).shows(line.value)) continue;
    for (int i = 0; i < (level ? columns : plot_rows); ++i) {
      if (level)
        grid.put(y.cell(line.value), i, "╌", 0);
      else
        grid.put(i, x.cell(line.value), "╎", 0);
    }
  }
  const auto with = pens(chart.curves, style);
  // What was measured lies over what theory says.
  const auto measured = [](const Curve& curve) {
    return curve.style != CurveStyle::theory && curve.style != CurveStyle::front;
  };
  for (const bool now : {false, true})
    for (size_t i = 0; i < with.size(); ++i)
      if (measured(chart.curves[i]) == now) draw_curve(grid, x, y, chart.curves[i], with[i]);
  for (const auto& note : chart.annotations) {
    if (x.shows(note.x) && y.shows(note.y)) grid.put(y.cell(note.y), x.cell(note.x), "◆", 0);
  }

  std::vector<std::string> labels(static_cast<size_t>(plot_rows));
  for (const auto& tick : y_ticks.ticks)
    if (y.shows(tick.value)) labels[static_cast<size_t>(y.cell(tick.value))] = tick.label;

  std::string text = y_ticks.label.empty() ? "" : "  " + y_ticks.label + "\n";
  for (int row = 0; row < plot_rows; ++row) {
    const std::string& label = labels[static_cast<size_t>(row)];
    text += padded("", margin - 1 - display_width(label)) + label + (label.empty() ? " │" : " ┤") +
            grid.row(row, style) + "\n";
  }
  text += horizontal_axis(x, x_ticks, columns);

  std::string key;
  const auto add_key = [&](const std::string& sign, const std::string& label) {
    if (!label.empty()) key += wrapped(sign + " " + label, style, margin + 1);
  };
  for (size_t i = 0; i < with.size(); ++i)
    add_key(style.colours && with[i].colour ? fmt::format("\033[{}m{}\033[0m", with[i].colour, with[i].sign)
                                            : with[i].sign,
            chart.curves[i].label);
  for (const auto& line : chart.references)
    add_key(line.axis == renderer::Reference::Across::y ? "╌" : "╎", line.label);
  for (const auto& note : chart.annotations)
    add_key("◆", fmt::format("{} at ({}, {})", note.text, number(note.x, 3), number(note.y, 3)));
  if (chart.heat_map) add_key("▒", Shading(*chart.heat_map).key());
  return text + key;
}

std::string bars(const Chart& chart, const Style& style) {
  double largest = 0;
  int name_width = 0, label_width = 0;
  for (const std::string& name : chart.bar_names) name_width = std::max(name_width, display_width(name));
  for (const auto& series : chart.bars) {
    label_width = std::max(label_width, display_width(series.label));
    for (const double value : series.values)
      if (std::isfinite(value)) largest = std::max(largest, std::abs(value));
  }
  const int room = std::max(10, style.width - name_width - label_width - 20);
  std::string text = "  " + chart.y.label + "\n";
  for (size_t i = 0; i < chart.bar_names.size(); ++i) {
    for (size_t s = 0; s < chart.bars.size(); ++s) {
      const double value = chart.bars[s].values[i];
      const int length = largest > 0 && std::isfinite(value)
                             ? static_cast<int>(std::lround(std::abs(value) / largest * room))
                             : 0;
      std::string bar;
      for (int k = 0; k < length; ++k) bar += s % 2 ? "▒" : "█";
      text += "  " + padded(s == 0 ? chart.bar_names[i] : "", name_width + 1) +
              padded(chart.bars[s].label, label_width + 1) + "│" + bar + " " + number(value, 3) + "\n";
    }
  }
  return text + (chart.x.label.empty() ? "" : "  (" + chart.x.label + ")\n");
}

Chart without_markup(Chart chart) {
  const auto clean = [](std::string& label) { label = course::without_markup(label); };
  for (Axis* const axis : {&chart.x, &chart.y}) {
    clean(axis->label);
    for (auto& tick : axis->ticks) clean(tick.label);
  }
  clean(chart.title);
  for (Curve& curve : chart.curves) clean(curve.label);
  for (auto& line : chart.references) clean(line.label);
  for (auto& note : chart.annotations) clean(note.text);
  for (auto& bars : chart.bars) clean(bars.label);
  for (std::string& name : chart.bar_names) clean(name);
  if (chart.heat_map) {
    clean(chart.heat_map->label);
    for (auto& kind : chart.heat_map->classes) clean(kind.name);
  }
  return chart;
}

}  // namespace

std::string text_chart(const Chart& marked_up, const Style& style) {
  const Chart chart = without_markup(marked_up);
  if (style.plain) return wrapped(chart_in_words(chart), style, 2);
  std::string text = chart.title.empty() ? "" : wrapped("**" + chart.title + "**", style, 2);
  if (!chart.bars.empty()) text += bars(chart, style);
  if (!chart.curves.empty() && chart.bars.empty()) return text + plot(chart, style);
  if (chart.heat_map) text += plot(chart, style);
  return text;
}

}  // namespace byhand::course
