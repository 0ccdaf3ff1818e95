#pragma once

#include <functional>
#include <optional>
#include <vector>

#include "lessons/08_where_methods_fail/laws/law.hpp"
#include "lessons/tutor/page.hpp"

namespace byhand::failures {

/// A knob of a map, and the values at which it is tried.
struct Knob {
  renderer::Axis axis;
  std::vector<double> values;
  bool whole = false;
};
/// `cells` values from `low` to `high`, evenly apart on the scale.
Knob knob(std::string label, double low, double high, int cells,
          renderer::Scale scale = renderer::Scale::logarithmic);
/// Whole ones, each once, so that there may be fewer.
Knob counting_knob(std::string label, double low, double high, int cells,
                   renderer::Scale scale = renderer::Scale::logarithmic);

/// How each run over two knobs ended, along x first.
struct Map {
  Knob x, y;
  std::vector<laws::Outcome> outcomes;
};

/// Makes every run of a map, side by side.
template <class Run>
Map map_of(const tutor::Page& page, const Knob& x, const Knob& y, const Run& run) {
  const int columns = static_cast<int>(x.values.size()), rows = static_cast<int>(y.values.size());
  return {x, y, page.side_by_side(columns * rows, [&](int cell) {
            return run(x.values[cell % columns], y.values[cell / columns]);
          })};
}

/// The share of all runs that settle where a law says so, or do not where it says that.
double share_foreseen(const Map& map, const std::function<bool(double x, double y)>& settles);

/// Cells that are outcomes, or empty where there is none. The legend names those that occur.
renderer::HeatMap cells(std::vector<double> x, std::vector<double> y,
                        const std::vector<std::optional<laws::Outcome>>& outcomes);

/// The map with a law's boundary over it: y for any x, or for whole x alone if its knob counts.
renderer::Chart chart(const Map& map, std::string law, const std::function<double(double x)>& boundary);

}  // namespace byhand::failures
