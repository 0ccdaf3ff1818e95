// Step 6: a row of balls, where rows cannot say what happens.

#include "lessons/05_contact/hanging_cradle.hpp"
#include "lessons/05_contact/steps.hpp"
#include "lessons/scenes/balls.hpp"

namespace byhand::contact {
namespace {

using Row = Simulation<PlaneBody>;

Row row_of_balls(const Setting& setting, const RowSolver& solver, double gap = 0) {
  Row row{newtons_cradle<PlaneBody>(setting.balls, 1, setting.speed), {solver}};
  for (int i = 0; i < setting.balls; ++i)
    row.scene.set_position(i, row.scene.bodies().pose[i].position + Linear<PlaneBody>(gap * i, 0));
  return row;
}

/// Of each ball, in units of the first one's before.
std::vector<double> speeds(const Row& row, double speed) {
  std::vector<double> speeds;
  for (const auto& V : row.scene.bodies().velocity) speeds.push_back(V.x() / speed);
  return speeds;
}

std::vector<double> after_a_step(const Setting& setting, const RowSolver& solver) {
  Row row = row_of_balls(setting, solver);
  row.step(setting.h);
  return speeds(row, setting.speed);
}

/// Once the impact has run through balls that are `gap` [m] apart, in steps of h [s].
std::vector<double> after_the_impact(const Setting& setting, double gap, double h) {
  Row row = row_of_balls(setting, Direct{}, gap);
  const double end = (setting.balls + 2) * (gap / setting.speed + 2 * h);
  while (row.time < end) row.step(h);
  return speeds(row, setting.speed);
}

/// All at once: momentum, and every ball but the first as fast as the next.
std::vector<double> shared(int balls) {
  std::vector<double> speeds(static_cast<std::size_t>(balls), 2.0 / balls);
  speeds.front() -= 1;
  return speeds;
}

double sum(const std::vector<double>& values, int power) {
  double sum = 0;
  for (const double value : values) sum += std::pow(value, power);
  return sum;
}

double largest_difference(const std::vector<double>& one, const std::vector<double>& other) {
  double largest = 0;
  for (std::size_t i = 0; i < one.size(); ++i) largest = std::max(largest, std::abs(one[i] - other[i]));
  return largest;
}

Chart gaps(const Setting& setting) {
  Curve first{.label = "first ball", .style = CurveStyle::line_and_markers},
      last{.label = "last ball", .style = CurveStyle::line_and_markers};
  const double gap = 0.001, crossing = gap / setting.speed;
  for (int i = -6; i <= 14; ++i) {
    const double share = std::pow(2, 0.5 * i);
    const std::vector<double> speeds = after_the_impact(setting, gap, share * crossing);
    first.x.push_back(share);
    first.y.push_back(speeds.front());
    last.x.push_back(share);
    last.y.push_back(speeds.back());
  }
  return {.x = {.label = "h / (time to cross a gap)", .scale = Scale::logarithmic},
          .y = {.label = "speed after the impact (v)"},
          .curves = {first, last},
          .references = {{Reference::Across::x, 1, "h = gap/v"}}};
}

}  // namespace

void cradle(const Setting& setting, Page& page) {
  const int n = setting.balls;
  const double v = setting.speed;
  const std::vector<double> direct = after_a_step(setting, Direct{});
  const GaussSeidel forward{.sweeps = 1, .warm_start = false},
      backward{.sweeps = 1, .warm_start = false, .order = SweepOrder::reverse},
      many{.sweeps = 200 * n, .warm_start = false};

  page.text(
      R"(@ balls of equal mass hang in a row and just touch, e = 1; the first comes at @ m/s. You know what happens: the
      last one leaves, and the others stay. Now ask (17), for all contacts at once. Only the first pair approaches, so
      only this pair must separate, at v; no other pair may approach.)",
      n, setting.speed);
  page.predict(
      {.ask = say(R"(@ balls, all contacts solved at once, e = 1. How fast is the first ball afterwards, in units
                  of its speed before?)",
                  n),
       .answer = direct.front(),
       .unit = "v",
       .tolerance = 0.04,
       .wrong = {{0,
                  "Real balls do that. But here one impulse in each contact acts on all balls at the same "
                  "instant."},
                 {-1, "Then the others together would have twice the momentum that came in."}},
       .hints = {"All other balls leave together, at one speed u: no pair among them may approach or separate.",
                 "momentum: v₁ + (N − 1)u = v;   separation of the first pair: u − v₁ = v.",
                 say("u = v + v₁, so v₁ + @(v + v₁) = v.", n - 1)},
       .hinted = (2.0 - n) / n,
       .right =
           say("(2 − N)/N = @; all the others leave together at 2/N = @ v.", Value((2.0 - n) / n, 3), 2.0 / n)});
  const std::vector<double> one_forward = after_a_step(setting, forward),
                            one_backward = after_a_step(setting, backward);
  std::vector<double> in_turn(static_cast<std::size_t>(n), 0.0);
  in_turn.back() = 1;
  Chart bars{.x = {.label = "ball"}, .y = {.label = "speed after the impact (v)"}};
  for (int i = 1; i <= n; ++i) bars.bar_names.push_back(say("@", i));
  bars.bars = {{"all at once", direct, {}},
               {"one sweep, first contact first", one_forward, {}},
               {"one sweep, last contact first", one_backward, {}},
               {"one collision after the other", in_turn, palette::muted}};
  page.figure(
      "cradle_speeds",
      say(R"(The speeds of @ balls after one step: solved at once, by one sweep in either direction (for the stop and
                  for the bounce), and by one collision after the other.)",
          n),
      bars);
  page.text(
      R"(Momentum is right in all four; energy only where all are solved at once and where one collision follows the
      other. Real balls do nearly the latter. (Touching balls are springs, so the collisions overlap in time and the
      other balls recoil a little.) One sweep from the first contact gives another result (@ of the energy is left),
      and one from the last yet another (@). More sweeps do not approach real balls either. They approach the first
      result, in which every row is satisfied.)",
      Value(sum(one_forward, 2), 2), Value(sum(one_backward, 2), 2));
  page.derivation(
      "All contacts at once",
      {{"impulses between the balls only: momentum stays", "v₁ + (N − 1)u = v", "v_1 + (N-1)\\,u = v"},
       {"e = 1 in the first contact", "u − v₁ = v", "u - v_1 = v"},
       {"insert u", "N v₁ = (2 − N) v", "N\\,v_1 = (2-N)\\,v"},
       {"so", "v₁ = (2 − N)/N · v,   u = 2/N · v", R"(v_1 = \frac{2-N}{N}\,v, \qquad u = \frac{2}{N}\,v)"}});
  page.text(
      R"(The rows do not know *when*. An impact runs through steel balls from one to the next and takes about a
      ten-thousandth of a second for each. The rows treat all impacts as simultaneous, and then momentum and energy are
      two equations for @ unknown speeds. We can supply what is missing: leave a small gap between the balls, and take
      steps so short that one collision is over before the next begins.)",
      n);
  page.figure(
      "cradle_gaps",
      R"(Balls a millimetre apart, all contacts solved at once in each step. Left, with steps shorter than the time
      to cross a gap: one collision after the other. Right: all collisions in one step.)",
      gaps(setting));
  page.sequence(
      "two_cradles",
      R"(Above: balls that touch, all contacts at once. Below: the same solver, a few millimetres between the
      balls, and steps short enough.)",
      Seconds{HangingCradle::seconds},
      [touching = HangingCradle(n, 0, HangingCradle::touching_step),
       apart = HangingCradle(n, HangingCradle::gap, HangingCradle::gap_step)](Canvas& canvas,
                                                                              double time) mutable {
        const auto [upper, lower] = canvas.page().inset(16).split_rows(0.5, 12);
        touching.advance(time);
        apart.advance(time);
        touching.draw(canvas, upper, "touching");
        apart.draw(canvas, lower, say("@ mm apart", 1000 * HangingCradle::gap));
      });
  page.text(
      R"(So (17) alone does not say what a solver *should* do here; know what yours does. This one follows Moreau:
      JV⁺ ≥ −e JV⁻ for all contacts at once, even for those that were separating when they were hit (they may turn back
      with the share e). With one e for all contacts and without friction, that cannot create energy. Bouncing only the
      contacts that approached, and holding the others at JV⁺ ≥ 0, can.)");

  page.measure("first ball, all at once", direct.front(), "v");
  page.claim("largest difference from (2 − N)/N and 2/N, all at once", largest_difference(direct, shared(n)), "v",
             is(0, "law of the simultaneous cradle", absolute(1e-9)));
  page.claim("energy, all at once", sum(direct, 2), "½mv²", is(1, "e = 1", absolute(1e-9)));
  for (const auto& [name, speeds] :
       {std::pair{"first contact first", one_forward}, std::pair{"last contact first", one_backward}})
    page.claim(say("momentum, one sweep, @", name), sum(speeds, 1), "mv",
               is(1, "(20) gives both bodies the same λ", absolute(1e-12)));
  page.claim(say("largest difference between @ sweeps and all at once", many.sweeps),
             largest_difference(after_a_step(setting, many), direct), "v", is(0, "one answer", absolute(1e-6)));
  const double gap = 0.001;
  page.claim("last ball, steps of half a gap's flight", after_the_impact(setting, gap, 0.5 * gap / v).back(), "v",
             is(1, "one collision after the other", absolute(1e-9)));
}

}  // namespace byhand::contact
