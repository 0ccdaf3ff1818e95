#include "renderer/chart.hpp"

#include <fmt/format.h>

#include <cmath>
#include <limits>
#include <stdexcept>

namespace byhand::renderer {
namespace {

constexpr double infinity = std::numeric_limits<double>::infinity();

// The range of the values that an axis can show.
class Extent {
 public:
  explicit Extent(const Axis& axis) : axis_(axis) {}

  void include(double value) {
    if (!std::isfinite(value) || (axis_.scale == Scale::logarithmic && value <= 0)) return;
    low_ = std::min(low_, value), high_ = std::max(high_, value);
  }
  void include(const std::vector<double>& values) {
    for (const double value : values) include(value);
  }

  // The range given for the axis, else the extent with a margin of `room` times its size on either side. If
  // `at_zero`, a range that begins near zero begins at zero.
  std::pair<double, double> range(double room, const char* name, bool at_zero = false) const {
    const bool logarithmic = axis_.scale == Scale::logarithmic;
    if (axis_.range) {
      const auto [low, high] = *axis_.range;
      if (!(std::isfinite(low) && std::isfinite(high) && low < high && (!logarithmic || low > 0)))
        throw std::invalid_argument(
            fmt::format("The {} axis of a chart goes from a lower to a higher {} number; got {} to {}.", name,
                        logarithmic ? "positive" : "finite", low, high));
      return *axis_.range;
    }
    if (low_ > high_) {
      if (logarithmic)
        throw std::invalid_argument(
            fmt::format("The logarithmic {} axis of a chart has no positive number to show.", name));
      return {0, 1};
    }
    if (logarithmic) {
      const double factor = low_ == high_ ? 2 : std::pow(high_ / low_, room);
      return {low_ / factor, high_ * factor};
    }
    const double margin = low_ < high_ ? room * (high_ - low_) : low_ == 0 ? 1 : 0.1 * std::abs(low_);
    return {at_zero && low_ >= 0 && low_ < margin ? 0 : low_ - margin,
            at_zero && low_ < 0 && high_ <= 0 && high_ > -margin ? 0 : high_ + margin};
  }

 private:
  const Axis& axis_;
  double low_ = infinity, high_ = -infinity;
};

void require(bool fine, const std::string& what, std::size_t got, std::size_t expected) {
  if (!fine) throw std::invalid_argument(fmt::format("{}: got {}, expected {}.", what, got, expected));
}

void check_lengths(const Chart& chart) {
  for (const Curve& c : chart.curves) {
    require(c.x.size() == c.y.size(), fmt::format("Curve '{}' has one y for each x", c.label), c.y.size(),
            c.x.size());
    require(c.point_labels.empty() || c.point_labels.size() == c.x.size(),
            fmt::format("Curve '{}' has one label for each point, or none", c.label), c.point_labels.size(),
            c.x.size());
    require(c.point_names.empty() || c.point_names.size() == c.x.size(),
            fmt::format("Curve '{}' has one name for each point, or none", c.label), c.point_names.size(),
            c.x.size());
  }
  for (const Bars& b : chart.bars)
    require(b.values.size() == chart.bar_names.size(),
            fmt::format("Bars '{}' have one value for each name", b.label), b.values.size(),
            chart.bar_names.size());
  if (const auto& map = chart.heat_map; map) {
    const std::size_t cells = map->x.size() * map->y.size();
    require(map->values.size() == cells && cells > 0, "A heat map has at least one cell and one value for each",
            map->values.size(), cells);
    if (!map->classes.empty())
      for (const double value : map->values)
        if (std::isfinite(value) &&
            !(value >= 0 && value < double(map->classes.size()) && value == std::floor(value)))
          throw std::invalid_argument(fmt::format("A cell of a map of {} classes is one of 0 to {}; got {}.",
                                                  map->classes.size(), map->classes.size() - 1, value));
  }
}

}  // namespace

std::pair<double, double> value_range(const HeatMap& map) {
  const Axis axis{.scale = map.scale, .range = map.range};
  Extent extent(axis);
  extent.include(map.values);
  if (map.diverging)
    for (const double value : map.values) extent.include(-value);
  return extent.range(0, "colour");
}

std::string class_name(const HeatMap& map, double value) {
  if (std::isinf(value)) return "failed";
  return std::isnan(value) ? "" : map.classes.at(std::size_t(value)).name;
}

std::vector<double> cell_edges(const std::vector<double>& centres, Scale scale) {
  const bool logarithmic = scale == Scale::logarithmic;
  const auto to = [&](double v) { return logarithmic ? std::log(v) : v; };
  const auto from = [&](double v) { return logarithmic ? std::exp(v) : v; };
  const std::size_t n = centres.size();
  if (n == 1)
    return logarithmic ? std::vector<double>{centres[0] / 2, centres[0] * 2}
                       : std::vector<double>{centres[0] - 0.5, centres[0] + 0.5};
  std::vector<double> edges{from(1.5 * to(centres[0]) - 0.5 * to(centres[1]))};
  for (std::size_t i = 0; i + 1 < n; ++i) edges.push_back(from(0.5 * (to(centres[i]) + to(centres[i + 1]))));
  edges.push_back(from(1.5 * to(centres[n - 1]) - 0.5 * to(centres[n - 2])));
  return edges;
}

ChartRanges ranges(const Chart& chart) {
  check_lengths(chart);
  Extent x(chart.x), y(chart.y);
  bool only_lines = true;
  for (const Curve& c : chart.curves) {
    if (chart.heat_map) break;  // the map is the frame; curves over it are cut off there
    for (std::size_t i = 0; i < c.x.size(); ++i) {
      if (!std::isnan(c.y[i])) x.include(c.x[i]);
      if (!std::isnan(c.x[i])) y.include(c.y[i]);
    }
    only_lines = only_lines && (c.style == CurveStyle::line || c.style == CurveStyle::theory);
    if (c.style == CurveStyle::stems) y.include(0.0);
  }
  for (const Bars& b : chart.bars) y.include(b.values);
  if (!chart.bars.empty()) x.include(-0.6), x.include(double(chart.bar_names.size()) - 0.4), y.include(0.0);
  if (const auto& map = chart.heat_map; map) {
    x.include(cell_edges(map->x, chart.x.scale));
    y.include(cell_edges(map->y, chart.y.scale));
  }
  for (const Annotation& a : chart.annotations) x.include(a.x), y.include(a.y);
  for (const Reference& r : chart.references) (r.axis == Reference::Across::x ? x : y).include(r.value);
  const bool tight = chart.heat_map.has_value();
  return {x.range(tight || only_lines ? 0 : 0.04, "x"), y.range(tight ? 0 : 0.06, "y", true)};
}

}  // namespace byhand::renderer
