// A chapter of the appendix: energy over a thousand periods.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/09_what_accuracy_costs/survey.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::accuracy {
namespace {

struct Kept {
  std::string name;
  std::vector<double> periods, change;  // the largest change of energy since the sample before, over mgL
};

/// What becomes of the energy of a pendulum over so many periods, seen at about `samples` times.
Kept keep(const Problem& problem, const Family& family, const Knobs& knobs, double period, double periods,
          int samples) {
  Kept kept{family.name + described_knobs(family, knobs), {}, {}};
  AnyScene scene = problem.start();
  const byhand::Setting setting = family.setting(knobs);
  scene.use(setting.method);
  const double energy = scene.energy(), scale = scene.energy_scale();
  double largest = 0, next = 1;
  const double stride = std::pow(periods, 1.0 / samples);
  while (kept.periods.empty() || kept.periods.back() < periods) {
    scene.step(frame);
    const double change = std::abs(scene.energy() - energy) / scale;
    largest = std::max(largest, change);
    if (scene.time() < next * period) continue;
    kept.periods.push_back(scene.time() / period);
    kept.change.push_back(std::isfinite(largest) && largest < 10 ? largest : INFINITY);
    if (!(largest < 10)) break;
    largest = 0;
    next = std::min(periods, std::max(next * stride, next + 1));
  }
  return kept;
}

/// "bounded", "drifting", "lost".
std::string verdict(const Kept& kept) {
  const double first = kept.change.front(), last = kept.change.back();
  if (!std::isfinite(last)) return "blown up";
  if (last > 0.5) return "lost";
  return last < 2 * first ? "bounded" : "drifting";
}

}  // namespace

void thousand_periods(Page& page) {
  const Problem problem("pendulum", {{"length", 2}, {"mass", 3}});
  const double period =
      SimplePendulum(problem["angle"] * std::numbers::pi / 180, problem["length"], problem["gravity"]).period();
  constexpr double periods = 1000;
  const Knobs whole = with_cure({}, Cure::baumgarte);
  const std::vector<std::pair<const char*, Knobs>> ways{
      {"RATTLE", {}}, {"implicit midpoint", {}}, {"RK4", {}}, {"direct", whole}, {"XPBD", {}}};
  const auto kept = page.side_by_side(static_cast<int>(ways.size()), [&](int i) {
    const auto& [name, knobs] = ways[static_cast<std::size_t>(i)];
    return keep(problem, family_named(name), knobs, period, periods, 24);
  });
  renderer::Chart chart{
      .title = title_of(problem),
      .x = {.label = "periods", .scale = renderer::Scale::logarithmic},
      .y = {.label = "largest change of energy, over mgL", .scale = renderer::Scale::logarithmic}};
  std::string said;
  for (const Kept& one : kept) {
    chart.curves.push_back({.label = one.name,
                            .x = one.periods,
                            .y = one.change,
                            .style = renderer::CurveStyle::line_and_markers,
                            .place = pictures::place_of(one.name)});
    const bool finite = std::isfinite(one.change.back());
    said += say("\n- @: @, @ after @ periods", one.name, verdict(one),
                finite ? say("@ of mgL", Value(one.change.back(), 2)) : std::string("beyond ten times mgL"),
                Value(one.periods.back(), 4));
  }
  page.text(
      R"(Ten seconds do not tell what becomes of a clock. So here is a pendulum for @ periods, one step a frame. A
      bounded error swings about the true energy; a drifting one grows with time; the rest is damping that no one
      asked for.)",
      periods);
  page.figure("thousand_periods",
              say("Change of energy of a pendulum over @ periods: the largest since the point before.", periods),
              chart);
  page.text("What becomes of the energy:\n" + said);
  page.claim("RATTLE: change of energy at the end, over that of the first period",
             kept[0].change.back() / kept[0].change.front(), "1", is_at_most(2, "symmetric: bounded for good"));
  page.claim("implicit midpoint: change of energy at the end, over that of the first period",
             kept[1].change.back() / kept[1].change.front(), "1",
             is_at_least(10, "its forces hold C̈ = 0 only, so C and the energy leave in the end"));
  page.claim("XPBD: change of energy at the end", kept[4].change.back(), "1",
             is_at_least(0.9, "each projection takes speed away: it comes to rest"));
}

}  // namespace byhand::accuracy
