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

/// On which side of a law's limit runs settle.
enum class Settles { below, above };

/// How a map agrees with a law. Only runs within a factor of 2 of the limit count: far from it any law is right.
struct Agreement {
  int right = 0, runs = 0;
  std::vector<double> factors;  // by column, sorted: on which multiple of the law's limit the runs change sides

  /// Median over the columns, and the ends of its 95 % interval.
  double factor() const { return factors[factors.size() / 2]; }
  double low() const { return factors[rank()]; }
  double high() const { return factors[factors.size() - 1 - rank()]; }
  /// "The law predicts 85 of 88 runs near its limit …"; `explained`: with what that means.
  std::string sentence(bool explained = false) const;

 private:
  std::size_t rank() const;
};
Agreement agreement(const Map& map, const std::function<double(double x)>& boundary, Settles side);
/// A claim that the limit fitted to the map is the law's within `tolerance`, for maps of 10 × 10 cells or more.
void claim_agreement(course::Page& page, const Agreement& agreement, double tolerance, const std::string& law,
                     const course::Parameter<int>& resolution);

/// What the outcomes are called in a scene, in the order of laws::Outcome.
using OutcomeNames = std::array<std::string, 5>;
inline const OutcomeNames outcome_names{"settles", "drifts", "rings", "explodes", "no solution"};

/// Cells that are outcomes, or empty where there is none. The legend names those that occur.
renderer::HeatMap cells(std::vector<double> x, std::vector<double> y,
                        const std::vector<std::optional<laws::Outcome>>& outcomes,
                        const OutcomeNames& names = outcome_names);

/// " Some columns swing instead of falling (“rings”): they fail too.", or "" where the map has no such cell.
std::string on_ringing(const Map& map);

/// The map with a law's boundary over it: y for any x, or for whole x alone if its knob counts.
renderer::Chart chart(const Map& map, std::string law, const std::function<double(double x)>& boundary,
                      const OutcomeNames& names = outcome_names);

}  // namespace byhand::failures
