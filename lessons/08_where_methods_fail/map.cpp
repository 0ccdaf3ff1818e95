#include "lessons/08_where_methods_fail/map.hpp"

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

std::string Agreement::sentence() const { return course::say("The law predicts @ of @ runs.", right, runs); }

Agreement agreement(const Map& map, const std::function<bool(double x, double y)>& settles) {
  const std::size_t columns = map.x.values.size();
  Agreement result{0, static_cast<int>(map.outcomes.size())};
  for (std::size_t i = 0; i < map.outcomes.size(); ++i)
    result.right +=
        (map.outcomes[i] == Outcome::settles) == settles(map.x.values[i % columns], map.y.values[i / columns]);
  return result;
}

void claim_agreement(course::Page& page, const Agreement& agreement, double share, const std::string& law,
                     const course::Parameter<int>& resolution) {
  page.claim("share of runs that end as the law says", agreement.share(), "1", is(share, law, course::at_least()),
             Quantity("resolution", resolution) >= 10);
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
