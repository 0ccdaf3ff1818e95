#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::single_constraint {
namespace {

/// The greatest tension on the first way through the lowest point [N].
double peak_tension(const Setting& setting, double h, double period) {
  double peak = 0;
  for (const Sample& sample : swing(setting, h, 0.4 * period)) peak = std::max(peak, sample.tension);
  return peak;
}

Chart tension_chart(const Swing& run, const SimplePendulum& exact, double mass, double end) {
  const double weight = mass * gravity();
  const Curve law = pictures::theory(
      "exact", 0, end, [&](double t) { return exact.tension(t, mass) / weight; }, 400);
  Curve measured =
      curve("−λ|d|/h", run, &Sample::time, [weight](const Sample& sample) { return sample.tension / weight; });
  measured.colour = palette::force;
  return {.x = {.label = "time (s)"}, .y = {.label = "tension (m·g)"}, .curves = {law, measured}};
}

void draw_frame(Canvas& canvas, const Sample& now, const Swing& run, const Chart& chart, double weight) {
  const auto [scene, beside] = canvas.page().inset(20).panels(0.5);
  const double length = run.front().position.norm(), newton = 0.26 * length / weight;
  std::vector<Point> seen{{0, 0}, {-length, -1.35 * length}, {length, 0.1 * length}};
  for (const Sample& sample : run) seen.emplace_back(sample.position);
  // Where the scene is low, its words are above it.
  const Rectangle below{scene.x, scene.y, scene.width, scene.height - (scene.is_high() ? 0 : 80)};
  canvas.look(fit(bounds(seen), below, scene.is_high() ? 30 : 10));
  const ArrowKind force{palette::force, newton, "N"};
  pictures::draw(canvas, {.bobs = {{now.position, 1}}, .rods = {{{0, 0}, now.position}}, .anchors = {{0, 0}}});
  // Beside the rod, which it would cover, and from the bob's edge on, which would hide a weak one.
  const Vector along = now.position / now.position.norm();
  canvas.vector(now.position + 16 / canvas.camera().scale * Vector(-along.y() - along.x(), along.x() - along.y()),
                -now.tension * along, force);
  canvas.vector(now.position, Vector(0, -weight), {palette::muted, newton, "N"});
  canvas.look_at_page();
  canvas.text({scene.centre().x(), scene.top() - 14},
              say("tension @ m·g@", std::round(1000 * now.tension / weight) / 1000,
                  now.tension < 0 ? ": the rod pushes" : ""),
              {.size = 22, .colour = palette::force, .bold = true});
  canvas.text({scene.centre().x(), scene.top() - 44}, say("weight m·g = @ N", Value(weight, 3)),
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
  const auto shown = [&](double step) { return course::without_rounding(pull(step), weight); };
  page.text(
      R"(Half the step, half the λ: an impulse grows with the time it acts. So λ|d|/h is the force along
      d, and −λ|d|/h is the tension of the rod. In the first step from @°:

      - with h = @ s the tension is @ N
      - with h/4: @ N
      - with h/64: @ N
      - m·g·cosθ, the part of the weight along the rod: @ N@)",
      setting.angle(), setting.h, shown(h), shown(h / 4), shown(h / 64), course::without_rounding(held, weight),
      shown(h) < 0 ? ". It is negative: the rod pushes" : "");
  double worst = 0;
  for (int i = 0; i <= 6; ++i) worst = std::max(worst, std::abs(pull(h / (1 << i)) - held));
  page.claim("tension at release, the worst of h … h/64", worst, "N",
             is(0, "distance from m·g·cosθ", absolute(1e-13 * weight)));

  const SimplePendulum exact(radians(setting.release()), length, gravity());
  const double period = exact.period(), lowest = exact.tension(period / 4, mass) / weight;
  const double peak = peak_tension(setting, h, period) / weight;
  page.predict(
      {.ask = say(
           R"(Now let it swing from rest at @°. How large is the tension when the bob passes the lowest point, in
                  units of its weight m·g?)",
           setting.release()),
       .answer = lowest,
       .unit = "m·g",
       .tolerance = 0.1 * std::min(1.0, lowest - 1),
       .wrong = {{1,
                  say("That only holds the weight. Bending the bob's path into a circle takes mv²/L = @ m·g more.",
                      lowest - 1)},
                 {lowest - 1, "That is the part that bends the path. The weight comes on top."}},
       .hints = {"What does the rod do at the lowest point besides holding the weight?",
                 "Tension = m·g + mv²/L. How fast is the bob at the bottom? Use energy.",
                 say("v² = 2gL(1 − cosθ₀): 1 + 2·(1 − cos @°) = …", setting.release())},
       .hinted = 1 + 2 * (1 - std::cos(radians(setting.release()))),
       .right = say(R"(By energy mv²/L is 2(1 − cosθ₀) times m·g; with the weight that makes 3 − 2cosθ₀. The solver
                    measures @ m·g with this h.)",
                    peak)});

  const double end = std::min(period, 4.0);
  const Swing run = swing(setting, h, end);
  const Chart chart = tension_chart(run, exact, mass, end);

  page.sequence("swing",
                "The tension (orange) and the weight (grey); right: −λ|d|/h, and dashed m(g·cosθ + Lθ̇²) "
                "of the exact "
                "pendulum. The solver knows nothing of circles.",
                Seconds{end},
                [=](Canvas& canvas, double time) { draw_frame(canvas, at(run, time), run, chart, weight); });

  const double error = peak - lowest, half = peak_tension(setting, h / 2, period) / weight - lowest,
               step = std::sqrt(gravity() / length) * h;
  page.text(
      R"(At the bottom the tension is @ m·g in this run and @ m·g exactly. The @ m·g in between is the error of the
      time step, not of the solver, which makes JV zero to rounding; steps 6 and 7 of this lesson show where it
      comes from. With h/2 it is @ m·g. @)",
      lowest + error, lowest, small_error(std::abs(error)), small_error(std::abs(half)),
      page.verdict({{.when = within(1.8, Quantity("error with h, over that with h/2", error / half), 2.2),
                     .say = "Half the time step makes about half the error."}}));
  const Condition fine =
      where(Quantity("h·√(g/L)", step) <= 0.05, within(30, Quantity("release", setting.release, "°"), 120));
  page.claim("greatest tension, from h and h/2 towards h = 0", lowest + 2 * half - error, "m·g",
             is(lowest, "3 − 2·cosθ₀, from energy", relative(5 * step * step)), fine);
  page.claim("error of the tension with h, over that with h/2", error / half, "1",
             is(2, "the step is of first order", absolute(6 * step)), fine);
}

}  // namespace byhand::single_constraint
