#pragma once

#include <optional>
#include <string>
#include <utility>
#include <vector>

#include "renderer/canvas.hpp"
#include "renderer/ticks.hpp"

namespace byhand::renderer {

struct Axis {
  std::string label{};  ///< quantity with its unit: "stretch (mm)"
  Scale scale = Scale::linear;
  std::optional<std::pair<double, double>>
      range{};                ///< lowest and highest value; chosen from the data when absent
  bool reversed = false;      ///< low values at the right or top: rows of a matrix
  std::vector<Tick> ticks{};  ///< instead of the automatic ones: names, multiples of π
};

enum class CurveStyle {
  line,
  markers,
  line_and_markers,
  stems,   ///< a thin line from zero up to a marker
  theory,  ///< dashed: what should be, not what was measured
  front,   ///< a broad pale staircase under the others, level and then upright from each point to the next: what
           ///< can be had
};

/// Values of y over x, of one length. NaN in either leaves a gap. An infinite value is a run that failed: a
/// cross at the edge of the chart on its side. A curve without points stands in the legend alone.
struct Curve {
  std::string label{};
  std::vector<double> x{}, y{};
  CurveStyle style = CurveStyle::line;
  std::optional<Colour> colour{};  ///< the next of the series (theory: palette::theory) when absent
  std::vector<std::string>
      point_labels{};  ///< a text at each point (the knob turned there, why it failed), or none
  std::vector<std::string> point_names{};  ///< what the data call each point, where not all have room for a label
};

/// One bar for each of `Chart::bar_names`; several series stand side by side.
struct Bars {
  std::string label{};
  std::vector<double> values{};
  std::optional<Colour> colour{};
};

/// What a cell may be, where it is one of a few things rather than a number.
struct CellClass {
  std::string name{};
  Colour colour{};
};

/// Values over a grid of cells. x and y are the centres of columns and rows, rising or falling; `values` go
/// along x first: value(row, column) = values[row · x.size() + column]. NaN leaves the cell empty, an
/// infinite value (a run that failed) is crossed out.
struct HeatMap {
  std::string label{};  ///< of the colour bar, with unit
  std::vector<double> x{}, y{}, values{};
  bool diverging = false;  ///< zero is paper, signs differ in hue
  Scale scale = Scale::linear;
  std::optional<std::pair<double, double>> range{};
  bool square = false;               ///< cells as high as wide: matrices
  std::vector<CellClass> classes{};  ///< if there are any, values are their indices and the legend names them
};

/// A text at a place in the units of the axes, with a dot.
struct Annotation {
  double x = 0, y = 0;
  std::string text{};
};

/// A thin dashed line across the chart at a value of one axis.
struct Reference {
  enum class Across { x, y };
  Across axis = Across::y;  ///< whose value it marks: y draws a level line
  double value = 0;
  std::string label{};
};

/// A chart as a value: it can be drawn, printed as text or written as data. Curves and a heat map share the
/// axes; bars stand at 0, 1, 2, … of x under `bar_names`, and curves may be drawn over them there.
struct Chart {
  std::string title{};
  Axis x{}, y{};
  std::vector<Curve> curves{};
  std::vector<std::string> bar_names{};
  std::vector<Bars> bars{};
  std::optional<HeatMap> heat_map{};
  std::vector<Annotation> annotations{};
  std::vector<Reference> references{};
};

/// What each axis shows: its range if given, else the data's with a little room (zero included for bars and
/// stems). Throws std::invalid_argument for lengths that differ, an empty range or nothing to show on a
/// logarithmic axis.
struct ChartRanges {
  std::pair<double, double> x, y;
};
ChartRanges ranges(const Chart& chart);

/// The values that the two ends of a heat map's colour bar stand for: its range if given, else the least and the
/// greatest finite value; symmetric about zero when it is diverging.
std::pair<double, double> value_range(const HeatMap& map);

/// The n + 1 borders of n cells with these centres: halfway between them on the axis.
std::vector<double> cell_edges(const std::vector<double>& centres, Scale scale);

/// The name of the class that a cell of a map with classes has; empty for a cell that is empty.
std::string class_name(const HeatMap& map, double value);

/// Draws the chart into `frame` (points on the page), axes and labels included; the canvas's camera stays as
/// it was. Labels stand at the ends of the curves where they fit, else in a legend where the chart is
/// emptiest, or beside it where there are many.
/// Returns the rectangle between the axes. Throws as `ranges` does, and for a frame without room for the labels.
Rectangle draw(Canvas& canvas, const Chart& chart, const Rectangle& frame);

}  // namespace byhand::renderer
