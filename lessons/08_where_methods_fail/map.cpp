#include "lessons/08_where_methods_fail/map.hpp"

#include <algorithm>
#include <cmath>

#include "renderer/palette.hpp"

namespace byhand::failures {
namespace {

using laws::Outcome;
using renderer::Scale;
namespace palette = renderer::palette;

double between(const Knob& knob, double share) {
  const std::vector<double> edges = renderer::cell_edges(knob.values, knob.axis.scale);
  const double low = edges.front(), high = edges.back();
  return knob.axis.scale == Scale::linear ? low + share * (high - low) : low * std::pow(high / low, share);
}

}  // namespace

// From pale to dark: in grey they still tell what is worse.
std::vector<renderer::CellClass> classes() {
  return {{"settles", {222, 232, 236}},
          {"drifts", {122, 178, 214}},
          {"rings", palette::highlight},
          {"explodes", renderer::mix(palette::force, palette::ink, 0.45)}};
}

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
  for (double& value : whole.values) value = std::round(value);
  whole.values.erase(std::unique(whole.values.begin(), whole.values.end()), whole.values.end());
  return whole;
}

double share_foreseen(const Map& map, const std::function<bool(double x, double y)>& settles) {
  const std::size_t columns = map.x.values.size();
  double right = 0;
  for (std::size_t i = 0; i < map.outcomes.size(); ++i)
    right +=
        (map.outcomes[i] == Outcome::settles) == settles(map.x.values[i % columns], map.y.values[i / columns]);
  return right / static_cast<double>(map.outcomes.size());
}

double share(const Map& map, Outcome outcome) {
  return static_cast<double>(std::count(map.outcomes.begin(), map.outcomes.end(), outcome)) /
         static_cast<double>(map.outcomes.size());
}

renderer::Chart chart(const Map& map, std::string law, const std::function<double(double x)>& boundary) {
  renderer::HeatMap cells{.label = "how the run ends", .x = map.x.values, .y = map.y.values};
  for (const Outcome outcome : map.outcomes) cells.values.push_back(static_cast<double>(outcome));
  cells.classes = classes();
  renderer::Curve curve{.label = std::move(law), .style = renderer::CurveStyle::theory};
  curve.colour = palette::ink;
  const double low = between(map.y, 0), high = between(map.y, 1);
  constexpr int points = 200;
  for (int i = 0; i <= points; ++i) {
    const double x = between(map.x, static_cast<double>(i) / points), y = boundary(x);
    curve.x.push_back(x);
    curve.y.push_back(y >= low && y <= high ? y : NAN);
  }
  return {.x = map.x.axis, .y = map.y.axis, .curves = {std::move(curve)}, .heat_map = std::move(cells)};
}

}  // namespace byhand::failures
