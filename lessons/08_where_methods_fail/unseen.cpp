// Deeper: what passes between two looks.

#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/tunnelling.hpp"

namespace byhand::failures {
namespace {

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

  page.text(
      R"(This is the third family at its plainest. Contacts are looked for once a step, where the bodies are at that
      moment. A ball of radius @ m that flies at a wall is turned back if a step finds it within @ m of the wall (the
      margin of this scene) or in it, before its centre has reached the middle of the wall.)",
      ball_radius, FlyingBalls{}.margin);
  page.predict(
      {.ask =
           say(R"(@ such balls fly at @ m/s at a wall @ m thick, each a little later than the last, at 60 steps a
                  second. How many get through?)",
               balls, speed, wall),
       .answer = passed,
       .unit = "balls",
       .tolerance = 0.06 * balls,
       .wrong = {{0,
                  R"(Between two steps a ball moves by half a metre. No solver can solve a contact that it is never
                 told of.)"},
                 {static_cast<double>(balls), "Some of them are near the wall when a step looks."},
                 {balls - passed, "Those are turned back."}},
       .hints = {"How far does a ball fly in a step, and over which distance can it be found?",
                 "Share that is found: (radius + margin + half the wall)/(v h).",
                 say("A share (@ + @ + @)/@ of the balls is found; the others of the @ pass.", ball_radius,
                     FlyingBalls{}.margin, wall / 2, speed * step, balls)},
       .hinted = balls * share_by_law(speed, wall),
       .right = say("A ball can be found over @ m, and a step is @ m long; the rest pass between two steps.",
                    Value(seen_for(wall), 3), speed * step)});
  const Knob speeds = knob("speed (m/s)", 2, 100, setting.resolution),
             walls = knob("thickness of the wall (m)", 0.01, 1, setting.resolution);
  const int columns = static_cast<int>(speeds.values.size());
  renderer::HeatMap map{.label = "share that passes", .x = speeds.values, .y = walls.values, .range = {{0, 1}}};
  const auto at = [&](int cell) {
    return FlyingBalls{.speed = speeds.values[cell % columns], .wall = walls.values[cell / columns]};
  };
  map.values = page.side_by_side(columns * static_cast<int>(walls.values.size()),
                                 [&](int cell) { return laws::share_that_passes(at(cell), 50); });
  double worst = 0;
  for (int cell = 0; cell < static_cast<int>(map.values.size()); ++cell)
    worst = std::max(worst, std::abs(map.values[cell] - share_by_law(at(cell).speed, at(cell).wall)));
  renderer::Curve law{.label = "vh = r + margin + d/2", .style = renderer::CurveStyle::theory};
  law.colour = renderer::palette::ink;
  for (int i = 0; i <= 100; ++i) {
    law.y.push_back(0.009 * std::pow(1.2 / 0.009, i / 100.0));
    law.x.push_back(seen_for(law.y.back()) / step);
  }
  page.figure("speed_and_thickness",
              "Each cell is 50 flights. Dashed: a step is as long as the distance over which a ball can be found.",
              renderer::Chart{.x = speeds.axis, .y = walls.axis, .curves = {law}, .heat_map = map});
  page.text(
      R"(**Which knob?** A shorter step, a thicker wall, a wider margin, or *speculative contacts*: for bodies that
      approach at v the margin grows by vh, so their contact is found before they touch. This solver does so by default
      (it is switched off here), and then a ball that flies straight at a wall is stopped at any speed.)");
  page.claim("balls that pass", passed, "1",
             is(balls * share_by_law(speed, wall), "law of tunnelling: 1 − (r + margin + d/2)/(vh)", absolute(2)));
  page.claim("largest deviation of a cell from the law", worst, "1", is_at_most(0.05, "law of tunnelling"));
  for (const double fast : {30.0, 1000.0})
    page.claim(say("share that passes at @ m/s with speculative contacts", fast),
               laws::share_that_passes({.speed = fast, .wall = wall, .lookahead = 1}, 50), "1",
               is(0, "the contact is found before they touch", absolute(0)));
}

}  // namespace byhand::failures
