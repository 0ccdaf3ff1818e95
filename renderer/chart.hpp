#pragma once

#include <limits>
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
  std::optional<std::pair<double, double>> range{};  ///< lowest and highest value; default: from the data
  bool reversed = false;      ///< values increase to the left or downwards, as the rows of a matrix do
  std::vector<Tick> ticks{};  ///< replace the automatic ticks: names, multiples of π
};

enum class CurveStyle {
  line,
  markers,
  line_and_markers,
  stems,   ///< a thin line from zero to each marker
  theory,  ///< dashed: predicted, not measured
  front,   ///< a broad pale staircase below the other curves: a Pareto front
};

/// Values of y over x, equally many. NaN leaves a gap. An infinite value marks a failed run by a cross at that
/// edge of the chart. A curve without points appears in the legend only.
struct Curve {
  std::string label{};
  std::vector<double> x{}, y{};
  CurveStyle style = CurveStyle::line;
  std::optional<int> place{};               ///< among the series, with its colour and marker; default: the next
  std::optional<Colour> colour{};           ///< default: that of its place; palette::theory for theory
  std::vector<std::string> point_labels{};  ///< a text at each point, or none
  std::vector<std::string> point_names{};  ///< names of the points in the CSV file, if they differ from the labels
};

/// One bar for each of `Chart::bar_names`. Several series are grouped.
struct Bars {
  std::string label{};
  std::vector<double> values{};
  std::optional<Colour> colour{};
};

/// A category of cells in a heat map.
struct CellClass {
  std::string name{};
  Colour colour{};
};

/// Values on a grid of cells. x and y are the centres of columns and rows, increasing or decreasing. `values` is
/// row-major: value(row, column) = values[row · x.size() + column]. NaN leaves a cell empty; an infinite value (a
/// failed run) is crossed out.
struct HeatMap {
  std::string label{};  ///< of the colour bar, with unit
  std::vector<double> x{}, y{}, values{};
  bool diverging = false;  ///< zero has the colour of the paper; the sign decides the hue
  Scale scale = Scale::linear;
  std::optional<std::pair<double, double>> range{};
  bool square = false;  ///< square cells, for matrices
  std::vector<CellClass>
      classes{};  ///< if not empty, the values are indices into it, and the legend lists the names
};

/// A dot with a text; coordinates in units of the axes.
struct Annotation {
  double x = 0, y = 0;
  std::string text{};
};

/// A thin dashed line across the chart at a value of one axis.
struct Reference {
  enum class Across { x, y };
  Across axis = Across::y;  ///< the axis of `value`: y draws a horizontal line
  double value = 0;
  std::string label{};
};

/// A chart, to be drawn, printed as text or written as data. Curves and a heat map share the axes. Bars are at
/// x = 0, 1, 2, …, labelled with `bar_names`.
struct Chart {
  std::string title{};
  Axis x{}, y{};
  std::vector<Curve> curves{};
  std::vector<std::string> bar_names{};
  std::vector<Bars> bars{};
  std::optional<HeatMap> heat_map{};
  std::vector<Annotation> annotations{};
  std::vector<Reference> references{};
  /// Curves other than theory are drawn up to this x, and a dot is at each end; the layout is that of the whole
  /// chart. For the chart beside a moving scene.
  double until = std::numeric_limits<double>::infinity();
};

/// The range of each axis: the given one, else that of the data with a margin, including zero for bars and stems.
/// Throws std::invalid_argument if lengths differ, a range is empty, or a logarithmic axis has no positive value.
struct ChartRanges {
  std::pair<double, double> x, y;
};
ChartRanges ranges(const Chart& chart);

/// The values at the ends of the colour bar: the given range, else the least and greatest finite value; symmetric
/// about zero for a diverging map.
std::pair<double, double> value_range(const HeatMap& map);

/// The n + 1 borders of n cells, halfway between their centres on the axis.
std::vector<double> cell_edges(const std::vector<double>& centres, Scale scale);

/// Name of the class of a cell in a map with classes; empty for an empty cell.
std::string class_name(const HeatMap& map, double value);

/// Draws the chart with axes and labels into `frame` (points on the page) and restores the camera. Curves are
/// labelled at their ends if there is room, else beside themselves where a label cannot be taken for that of
/// another curve, else in a legend in the emptiest place, or beside the chart if the legend is long. Returns the
/// rectangle between the axes. Throws as `ranges` does, and std::invalid_argument for a frame too small for the
/// labels.
Rectangle draw(Canvas& canvas, const Chart& chart, const Rectangle& frame);

/// The rectangle between the axes that `draw` would return; draws nothing.
Rectangle layout(Canvas& canvas, const Chart& chart, const Rectangle& frame);

}  // namespace byhand::renderer
