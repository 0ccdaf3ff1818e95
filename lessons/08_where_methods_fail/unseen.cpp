// Deeper: what passes between two looks.

#include <algorithm>
#include <cmath>

#include "lessons/08_where_methods_fail/laws/tunnelling.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::FlyingBalls;

constexpr double ball_radius = 0.05;  // [m]

/// How far a ball flies while the wall is seen and before its centre has passed the middle [m].
double seen_for(double wall) { return ball_radius + FlyingBalls{}.margin + wall / 2; }

double share_by_law(double speed, double wall) { return std::max(0.0, 1 - seen_for(wall) / (speed * step)); }

}  // namespace

void unseen(const Setting& setting, Page& page) {
  const double speed = 30, wall = 0.1;
  const int balls = 200;
  const double passed = balls * laws::share_that_passes({.speed = speed, .wall = wall}, balls);

  page.predict(
      {.ask = say(
           "@ balls of @ cm radius fly at @ m/s at a wall @ m thick, 60 steps a second. How many come through?",
           balls, 100 * ball_radius, speed, wall),
       .answer = passed,
       .unit = "balls",
       .tolerance = 0.06 * balls,
       .wrong = {{0,
                  R"(Between two steps a ball jumps half a metre; the solver cannot solve a contact that it is
                  never told of.)"},
                 {static_cast<double>(balls), "Some happen to be near when a step looks."}},
       .hints = {"How far does a ball go in a step, and along how much of that is it seen?"},
       .right =
           "A ball is seen along its radius, the margin and half of the wall; the rest of its step it is not."});
  page.text(
      R"(Family three at its plainest: contacts are looked for once a step, where bodies are then. A ball that is
      found anywhere from the margin before the wall to the wall's middle is turned back. That way is @ m, a step
      @ m.)",
      Value(seen_for(wall), 3), speed * step);
  const Knob speeds = knob("speed (m/s)", 2, 100, setting.resolution),
             walls = knob("thickness of the wall (m)", 0.01, 1, setting.resolution);
  const int columns = static_cast<int>(speeds.values.size());
  renderer::HeatMap map{
      .label = "share that passes (1)", .x = speeds.values, .y = walls.values, .range = {{0, 1}}};
  const auto at = [&](int cell) {
    return FlyingBalls{.speed = speeds.values[cell % columns], .wall = walls.values[cell / columns]};
  };
  map.values = page.side_by_side(columns * static_cast<int>(walls.values.size()),
                                 [&](int cell) { return laws::share_that_passes(at(cell), 50); });
  double worst = 0;
  for (int cell = 0; cell < static_cast<int>(map.values.size()); ++cell)
    worst = std::max(worst, std::abs(map.values[cell] - share_by_law(at(cell).speed, at(cell).wall)));
  renderer::Curve law{.label = "vh = r + margin + w/2", .style = renderer::CurveStyle::theory};
  law.colour = renderer::palette::ink;
  for (int i = 0; i <= 100; ++i) {
    law.y.push_back(0.009 * std::pow(1.2 / 0.009, i / 100.0));
    law.x.push_back(seen_for(law.y.back()) / step);
  }
  page.figure("speed_and_thickness",
              "Each cell is 50 flights. Dashed: what goes no farther in a step than it is seen.",
              renderer::Chart{.x = speeds.axis, .y = walls.axis, .curves = {law}, .heat_map = map});
  page.text(
      R"(**Which knob?** The step; a thicker wall; a wider margin; or contacts that are made before bodies touch
      (speculative contacts): for what approaches at v the margin grows by vh. A scene of this solver does that
      unless it is told not to, as here, and then what flies straight at a wall is stopped by it at any speed. A
      half-space has no other side, and nothing passes it.)");
  page.claim({.quantity = "balls that pass",
              .unit = "1",
              .expected = balls * share_by_law(speed, wall),
              .source = "law B16: 1 − seen/(vh)",
              .measured = passed,
              .tolerance = absolute(2)});
  page.claim({.quantity = "largest deviation of a cell from the law",
              .unit = "1",
              .expected = 0.05,
              .source = "law B16",
              .measured = worst,
              .tolerance = at_most()});
}

}  // namespace byhand::failures
