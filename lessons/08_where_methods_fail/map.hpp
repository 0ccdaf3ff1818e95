#pragma once

#include <functional>
#include <map>

#include "lessons/08_where_methods_fail/setting.hpp"
#include "lessons/laws/law.hpp"

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
Map map_of(const course::Page& page, const Knob& x, const Knob& y, const Run& run) {
  const int columns = static_cast<int>(x.values.size()), rows = static_cast<int>(y.values.size());
  return {x, y, page.side_by_side(columns * rows, [&](int cell) {
            return run(x.values[cell % columns], y.values[cell / columns]);
          })};
}

/// A map that no knob but the resolution changes, made when it is first wanted.
template <class Make>
const Map& kept(std::map<int, Map>& known, int resolution, const Make& make) {
  const auto [place, fresh] = known.try_emplace(resolution);
  if (fresh) place->second = make();
  return place->second;
}

/// How many of the runs settle where a law says so, and do not settle where it does not.
struct Agreement {
  int right = 0, runs = 0;

  double share() const { return static_cast<double>(right) / runs; }
  /// "The law predicts 337 of 340 runs."
  std::string sentence() const;
};
Agreement agreement(const Map& map, const std::function<bool(double x, double y)>& settles);
/// A claim that at least such a share of them agrees, for maps of 10 × 10 cells or more.
void claim_agreement(course::Page& page, const Agreement& agreement, double share, const std::string& law,
                     const course::Parameter<int>& resolution);

/// What the outcomes are called in a scene, in the order of laws::Outcome.
using OutcomeNames = std::array<std::string, 5>;
inline const OutcomeNames outcome_names{"settles", "drifts", "rings", "explodes", "no solution"};

/// Cells that are outcomes, or empty where there is none. The legend names those that occur.
renderer::HeatMap cells(std::vector<double> x, std::vector<double> y,
                        const std::vector<std::optional<laws::Outcome>>& outcomes,
                        const OutcomeNames& names = outcome_names);

/// The map with a law's boundary over it: y for any x, or for whole x alone if its knob counts.
renderer::Chart chart(const Map& map, std::string law, const std::function<double(double x)>& boundary,
                      const OutcomeNames& names = outcome_names);

}  // namespace byhand::failures
