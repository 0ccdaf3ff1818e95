#include <cmath>

#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/rods_and_bobs.hpp"

namespace byhand::single_constraint {
namespace {

using namespace tutor;
using namespace renderer;

/// The greatest tension on the first way through the lowest point [N].
double peak_tension(const Setting& setting, double h, double period) {
  double peak = 0;
  for (const Sample& sample : swing(setting, h, 0.4 * period)) peak = std::max(peak, sample.tension);
  return peak;
}

Chart tension_chart(const Swing& run, const SimplePendulum& exact, double mass, double end) {
  Curve theory{.label = "exact", .style = CurveStyle::theory};
  for (int i = 0; i <= 400; ++i) {
    theory.x.push_back(end * i / 400);
    theory.y.push_back(exact.tension(theory.x.back(), mass));
  }
  const Curve measured{.label = "−λ|d|/h",
                       .x = each(run, [](const Sample& s) { return s.time; }),
                       .y = each(run, [](const Sample& s) { return s.tension; }),
                       .colour = palette::force};
  return {.x = {.label = "time (s)"}, .y = {.label = "pull of the rod (N)"}, .curves = {theory, measured}};
}

void draw_frame(Canvas& canvas, const Sample& now, const Swing& run, const Chart& chart, double weight) {
  const auto [scene, beside] = canvas.page().inset(20).split_columns(0.5);
  const double length = run.front().position.norm(), newton = 0.26 * length / weight;
  std::vector<Point> seen{{0, 0}, {-length, -1.35 * length}, {length, 0.1 * length}};
  for (const Sample& sample : run) seen.emplace_back(sample.position);
  canvas.look(fit(bounds(seen), scene, 30));
  const ArrowKind force{palette::force, newton, "N"};
  pictures::draw(canvas, {.bobs = {{now.position, 1}}, .rods = {{{0, 0}, now.position}}, .anchors = {{0, 0}}});
  canvas.vector(now.position, -now.tension * now.position / now.position.norm(), force);
  canvas.vector(now.position, Vector(0, -weight), {palette::muted, newton, "N"});
  canvas.look_at_page();
  canvas.text({scene.centre().x(), scene.top() - 14},
              say("the rod pulls with @ N", std::round(10 * now.tension) / 10),
              {.size = 22, .colour = palette::force, .bold = true});
  canvas.text({scene.centre().x(), scene.top() - 44}, say("its weight is @ N", Value(weight, 3)),
              {.size = 20, .colour = palette::muted});
  draw(canvas, pictures::grown_to(chart, now.time), beside);
}

}  // namespace

void tension(const Setting& setting, Page& page) {
  const double mass = setting.mass(), length = setting.length(), h = setting.h(), weight = mass * gravity();
  const double held = weight * std::cos(radians(setting.angle()));
  const auto pull = [&](double step) {
    Pendulum scene = pendulum<PlaneParticle>(radians(setting.angle()), length, mass);
    add_gravity(scene.state(), scene.gravity, step);
    return -OneRow(scene).lambda * length / step;
  };
  page.text(
      R"(An impulse is a force times the time it acts. So λ by itself means little: half the step, half the λ. But
      λ|d|/h is the force along d, and −λ|d|/h the pull of the rod, its tension. Take the first step again, from
      @°:

      - with h = @ s it is @ N
      - with h/4: @ N
      - with h/64: @ N
      - what the rod must hold, m·g·cosθ: @ N)",
      setting.angle(), setting.h, pull(h), pull(h / 4), pull(h / 64), held);
  double worst = 0;
  for (int i = 0; i <= 6; ++i) worst = std::max(worst, std::abs(pull(h / (1 << i)) - held));
  page.claim({.quantity = "tension at release, the worst of h … h/64",
              .unit = "N",
              .expected = 0,
              .source = "distance from m·g·cosθ",
              .measured = worst,
              .tolerance = absolute(1e-13 * weight)});

  const SimplePendulum exact(radians(setting.release()), length, gravity());
  const double period = exact.period(), lowest = exact.tension(period / 4, mass) / weight;
  page.predict(
      {.ask = say(R"(Now let it swing from rest at @°. How hard does the rod pull when the bob passes the lowest
                  point, in weights of the bob?)",
                  setting.release()),
       .answer = lowest,
       .unit = "weights",
       .tolerance = 0.1,
       .wrong = {{1,
                  say("That only holds the weight; turning it round costs mv²/L = @ weights more.", lowest - 1)},
                 {lowest - 1, "That is the turning part alone; the weight hangs on it as well."}},
       .hints = {"Energy gives v² at the bottom; to turn it into a circle takes mv²/L."},
       .right = say("The solver measures @ with this h.", peak_tension(setting, h, period) / weight)});

  const double end = std::min(period, 4.0);
  const Swing run = swing(setting, h, end);
  const Chart chart = tension_chart(run, exact, mass, end);
  page.figure(
      "tension_over_time",
      say(R"(What the solver's λ says the rod pulls with, against m(g·cosθ + Lθ̇²) of the exact pendulum, over @ s
          from @°. Nobody told the solver about circles. It begins exact and then falls short; the next two steps
          show why.)",
          end, setting.release()),
      chart);
  page.sequence("swing", "The swing, the pull of the rod (orange) and the weight (grey), and −λ|d|/h as it comes.",
                Seconds{end},
                [=](Canvas& canvas, double time) { draw_frame(canvas, at(run, time), run, chart, weight); });

  const double error = peak_tension(setting, h, period) / weight - lowest,
               half = peak_tension(setting, h / 2, period) / weight - lowest,
               step = std::sqrt(gravity() / length) * h;
  page.text(
      R"(At the bottom the run pulls with @ weights where the exact answer is @. What is missing is the step's
      error, not the solver's: with h/2 the error is @ instead of @.)",
      lowest + error, lowest, half, error);
  const bool fine = step <= 0.05 && setting.release() >= 30 && setting.release() <= 120;
  const std::string range = "h·√(g/L) ≤ 0.05, release 30° … 120°";
  page.claim({.quantity = "greatest tension, from h and h/2 towards h = 0",
              .unit = "weights",
              .expected = lowest,
              .source = "3 − 2·cosθ₀, from energy",
              .measured = lowest + 2 * half - error,
              .tolerance = relative(5 * step * step),
              .claimed = fine,
              .range = range});
  page.claim({.quantity = "error of the tension with h, over that with h/2",
              .unit = "1",
              .expected = 2,
              .source = "the step is of first order",
              .measured = error / half,
              .tolerance = absolute(6 * step),
              .claimed = fine,
              .range = range});
}

}  // namespace byhand::single_constraint
