#include "lessons/08_where_methods_fail/map.hpp"

#include <numbers>

#include "renderer/palette.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;

/// From one end of the outermost cells to the other, where a law is drawn.
std::vector<double> along(const Knob& knob) {
  const std::vector<double> edges = renderer::cell_edges(knob.values, knob.axis.scale);
  const double low = edges.front(), high = edges.back();
  std::vector<double> all;
  if (knob.whole)
    for (double x = std::ceil(low); x <= high; ++x) all.push_back(x);
  constexpr int points = 200;
  for (int i = 0; i <= points && !knob.whole; ++i) {
    const double share = static_cast<double>(i) / points;
    all.push_back(knob.axis.scale == Scale::linear ? low + share * (high - low)
                                                   : low * std::pow(high / low, share));
  }
  return all;
}

}  // namespace

Knob knob(std::string label, double low, double high, int cells, Scale scale) {
  Knob knob{{.label = std::move(label), .scale = scale}, {}};
  for (int i = 0; i < cells; ++i) {
    const double share = static_cast<double>(i) / (cells - 1);
    knob.values.push_back(scale == Scale::linear ? low + share * (high - low) : low * std::pow(high / low, share));
  }
  return knob;
}

Knob counting_knob(std::string label, double low, double high, int cells, Scale scale) {
  Knob whole = knob(std::move(label), low, high, cells, scale);
  whole.whole = true;
  for (double& value : whole.values) value = std::round(value);
  whole.values.erase(std::unique(whole.values.begin(), whole.values.end()), whole.values.end());
  return whole;
}

/// Of the median of n numbers by the sign test: the largest rank r with P(fewer than r below) <= 0.025.
std::size_t Agreement::rank() const {
  const double n = static_cast<double>(factors.size());
  double probability = std::pow(0.5, n), sum = probability;
  std::size_t rank = 0;
  while (sum <= 0.025) {
    ++rank;
    probability *= (n - static_cast<double>(rank) + 1) / static_cast<double>(rank);
    sum += probability;
  }
  return rank == 0 ? 0 : rank - 1;
}

std::string Agreement::sentence(bool explained) const {
  if (factors.empty()) return "No run of the map is near the limit of the law.";
  if (!explained)
    return course::say("The law predicts @ of the @ runs near its limit; the fitted limit, over the law's, is @.",
                       right, runs, Value(factor(), 3));
  const std::string interval =
      low() < high() ? course::say(" (95 % confidence interval @ to @)", Value(low(), 3), Value(high(), 3)) : "";
  return course::say(
      "Within a factor of 2 of its limit the law predicts @ of @ runs. The limit fitted to the map, over the "
      "law's, is @@.",
      right, runs, Value(factor(), 3), interval);
}

Agreement agreement(const Map& map, const std::function<double(double x)>& boundary, Settles side) {
  const std::size_t columns = map.x.values.size(), rows = map.y.values.size();
  Agreement result;
  for (std::size_t column = 0; column < columns; ++column) {
    const double limit = boundary(map.x.values[column]);
    std::vector<std::pair<double, bool>> near;  // share of the limit; whether it went as below it
    for (std::size_t row = 0; row < rows; ++row) {
      const double share = map.y.values[row] / limit;
      if (!(share > 0.5 && share < 2)) continue;
      const bool settled = map.outcomes[row * columns + column] == Outcome::settles;
      near.emplace_back(share, settled == (side == Settles::below));
      result.right += (share < 1) == near.back().second;
      ++result.runs;
    }
    // Where most runs lie on their side. Of a column that changes nowhere near the limit nothing is known but
    // that.
    std::size_t fewest = near.size() + 1;
    double factor = NAN;
    for (std::size_t split = 0; split <= near.size() && !near.empty(); ++split) {
      std::size_t wrong = 0;
      for (std::size_t i = 0; i < near.size(); ++i) wrong += (i < split) != near[i].second;
      const double at = split == 0             ? near.front().first / std::numbers::sqrt2
                        : split == near.size() ? near.back().first * std::numbers::sqrt2
                                               : std::sqrt(near[split - 1].first * near[split].first);
      const bool nearer = std::abs(std::log(at)) < std::abs(std::log(factor));
      if (wrong < fewest || (wrong == fewest && nearer)) fewest = wrong, factor = at;
    }
    // Of a map that ends near the limit, its edge says nothing.
    const bool within = !near.empty() && near.front().first < 0.8 && near.back().first > 1.25;
    if (within) result.factors.push_back(factor);
  }
  std::sort(result.factors.begin(), result.factors.end());
  return result;
}

void claim_agreement(course::Page& page, const Agreement& agreement, double tolerance, const std::string& law,
                     const course::Parameter<int>& resolution) {
  page.claim("limit fitted to the map, over the law's", agreement.factors.empty() ? NAN : agreement.factor(), "1",
             is(1, law, course::relative(tolerance)),
             both(Quantity("resolution", resolution) >= 10,
                  Quantity("columns across the limit", static_cast<double>(agreement.factors.size())) >= 6));
}

renderer::HeatMap cells(std::vector<double> x, std::vector<double> y,
                        const std::vector<std::optional<Outcome>>& outcomes, const OutcomeNames& names) {
  renderer::HeatMap map{.label = "how the run ends", .x = std::move(x), .y = std::move(y)};
  // From pale to dark: in grey they still tell what is worse.
  const std::array<renderer::Colour, 5> colours{{{205, 227, 214},
                                                 {112, 172, 212},
                                                 palette::highlight,
                                                 renderer::mix(palette::force, palette::ink, 0.45),
                                                 palette::ink}};
  for (std::size_t i = 0; i < names.size(); ++i) map.classes.push_back({names[i], colours[i]});
  for (const auto& outcome : outcomes) map.values.push_back(outcome ? static_cast<double>(*outcome) : NAN);
  for (std::size_t i = 0; i < map.classes.size(); ++i)
    if (std::count(map.values.begin(), map.values.end(), static_cast<double>(i)) == 0) map.classes[i].name.clear();
  return map;
}

std::string on_ringing(const Map& map) {
  const bool rings = std::count(map.outcomes.begin(), map.outcomes.end(), Outcome::rings) > 0;
  return rings ? " Columns that swing instead of falling (“rings”) fail too." : "";
}

renderer::Chart chart(const Map& map, std::string law, const std::function<double(double x)>& boundary,
                      const OutcomeNames& names) {
  const std::vector<double> edges = renderer::cell_edges(map.y.values, map.y.axis.scale);
  renderer::Curve curve{.label = std::move(law), .style = renderer::CurveStyle::theory};
  curve.colour = palette::ink;
  for (const double x : along(map.x)) {
    const double y = boundary(x);
    curve.x.push_back(x);
    curve.y.push_back(y >= edges.front() && y <= edges.back() ? y : NAN);
  }
  return {.x = map.x.axis,
          .y = map.y.axis,
          .curves = {std::move(curve)},
          .heat_map = cells(map.x.values, map.y.values, {map.outcomes.begin(), map.outcomes.end()}, names)};
}

}  // namespace byhand::failures
