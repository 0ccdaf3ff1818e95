#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/swing.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::single_constraint {
namespace {

constexpr double speed = 3;  // [m/s]

/// The bob at the lowest point, moving sideways, without gravity: JV = 0 from the start.
Pendulum weightless(const Setting& setting) {
  Pendulum scene = pendulum<PlaneParticle>(0, setting.length(), setting.mass());
  scene.gravity.setZero();
  scene.set_velocity(1, {speed, 0});
  return scene;
}

/// By how much the rod is too long after one step of h [m].
double stretch(const Setting& setting, double h) {
  return swing(weightless(setting), h, h).back().position.norm() - setting.length();
}

void draw_steps(Canvas& canvas, const Swing& run, double length) {
  std::vector<Point> circle, steps;
  for (int i = 0; i <= 200; ++i) circle.emplace_back(length * from_straight_down<PlaneParticle>(radians(1.8 * i)));
  for (const Sample& sample : run) steps.emplace_back(sample.position);
  canvas.look(fit(united(bounds(steps), bounds(circle)), canvas.page(1).inset(20), 30));
  canvas.path(circle, {palette::theory, 2, Dash::dashed});
  canvas.path(steps, {palette::velocity, 2});
  for (const Point& point : steps) canvas.line({0, 0}, point, {fade(palette::constraint, 0.25), 2});
  pictures::draw(canvas, {.bobs = {{steps.back(), 1}}, .rods = {{{0, 0}, steps.back()}}, .anchors = {{0, 0}}});
  for (std::size_t i = 0; i + 1 < steps.size(); ++i) canvas.mark(steps[i], Mark::disc, palette::velocity, 10);
  canvas.arrow(steps[0], steps[1], {palette::velocity, 3.5});
  const auto name = [&](const Point& end, const char* text) {
    const TextStyle style{
        .size = 22, .colour = palette::constraint, .anchor = Anchor::right, .halo = 3, .offset = {-14, 8}};
    canvas.text(0.6 * end, text, style);
  };
  name(steps.front(), "L");
  name(steps.back(), "ℓ > L");
  canvas.text(steps[0], "start", {.size = 20, .anchor = Anchor::top, .halo = 3, .offset = {0, -12}});
}

}  // namespace

void off_the_circle(const Setting& setting, Page& page) {
  const double length = setting.length(), h = setting.h(), millimetre = 1e-3;
  const double one = stretch(setting, h), law = speed * speed * h * h / (2 * length);
  const double ratio = speed * h / length;
  page.text(
      R"(After each solve JV is 0 to rounding. Does the rod keep its length? Take gravity away: the bob is at the
      lowest point and moves sideways at @ m/s, so JV = 0 from the start, λ = 0, and the step only moves the bob:)",
      speed);
  page.excerpt("solver/integrate/euler.hpp", "advance");
  page.predict(
      {.ask = say("It moves one step of h = @ s at @ m/s. By how much is the @ m rod too long after that step?",
                  setting.h, speed, length),
       .answer = one / millimetre,
       .unit = "mm",
       .tolerance = 0.1 * one / millimetre,
       .wrong = {{0, "JV = 0 sends the bob along the tangent, and the tangent leaves the circle."},
                 {speed * h / millimetre, "That is how far the bob moves; it moves at right angles to the rod."}},
       .hints = {"The bob moves v·h at right angles to the rod. How far is it from the fixed point then?",
                 "Pythagoras: √(L² + (vh)²) − L.",
                 say("√(@² + @²) m − @ m = …", length, Value(speed * h, 8), length)},
       .right =
           say(ratio <= 0.5 ? R"(The new length is the hypotenuse. For v·h much smaller than L the difference is
                                    close to (vh)²/2L, @ mm.)"
                            : R"(The new length is the hypotenuse. (vh)²/2L would be @ mm: that estimate needs
                                    v·h much smaller than L.)",
               law / millimetre)});
  const double coarse = 0.45 * length / speed;
  const Swing steps = swing(weightless(setting), coarse, 8 * coarse);
  page.figure(
      "off_the_circle",
      say(R"(The same bob, without gravity, in steps of @ s. Each step is at right angles to the rod at that moment, so every step makes
          the rod longer.)",
          coarse),
      [=](Canvas& canvas) { draw_steps(canvas, steps, length); });

  page.formula("√(L² + (vh)²) − L = @ mm,   (vh)²/2L = @ mm",
               R"(\sqrt{L^2 + (vh)^2} - L = @\ \mathrm{mm}, \qquad \frac{(vh)^2}{2L} = @\ \mathrm{mm})",
               one / millimetre, law / millimetre);
  Curve measured{.label = "one step of the solver", .style = CurveStyle::markers};
  Curve theory{.label = "(vh)²/2L", .style = CurveStyle::theory};
  for (int i = 0; i <= 6; ++i) {
    const double step = h / (1 << i);
    measured.x.push_back(step);
    measured.y.push_back(stretch(setting, step) / millimetre);
    theory.x.push_back(step);
    theory.y.push_back(speed * speed * step * step / (2 * length) / millimetre);
  }
  const double slope = std::log2(measured.y[0] / measured.y[1]);
  page.figure(
      "one_step",
      say(ratio <= 0.5
              ? R"(Stretch after one step against h. Halving h quarters it (slope @). But a second
                                  then has twice as many steps, so the drift per second only halves.)"
              : R"(Stretch after one step against h. From h to h/2 the slope is @; it becomes 2 where v·h is much smaller than L.)",
          Value(slope, 3)),
      Chart{.x = {.label = "time step h (s)", .scale = Scale::logarithmic},
            .y = {.label = "stretch after one step (mm)", .scale = Scale::logarithmic},
            .curves = {measured, theory}});

  const double second = 1;
  const Swing round = swing(weightless(setting), h, second);
  const Sample& last = round.back();
  const double radius = last.position.norm(), momentum = cross(last.position, last.velocity)[0];
  const double grown = laws::drifted_radius(length, speed, h, second);
  page.text(
      R"(After one second the rod is @ mm too long, and the bob is slower by @ m/s, because each impulse acts along the rod:
      the angular momentum mvℓ stays, so a longer rod means a slower bob.)",
      (radius - length) / millimetre, course::small_error(speed - momentum / radius, 3));

  page.derivation("How fast the rod grows, without gravity",
                  {{"Pythagoras: each step of length vh is at right angles to the rod, of length ℓ",
                    "ℓ² grows by v²h² a step, by v²h a second", R"(\frac{d\ell^2}{dt} = v^2 h)"},
                   {"angular momentum, with v₀ at ℓ = L", "v = v₀L/ℓ", R"(v = v_0 L/\ell)"},
                   {"multiply by 2ℓ²", "ℓ⁴ grows by 2v₀²L²h a second", R"(\frac{d\ell^4}{dt} = 2v_0^2L^2h)"},
                   {"integrate from 0 to t", "ℓ = L(1 + 2v₀²ht/L²)^¼",
                    R"(\ell = L\left(1 + \frac{2v_0^2ht}{L^2}\right)^{1/4})"}});

  page.claim("stretch after one step", one / millimetre, "mm",
             is(law / millimetre, "(vh)²/2L", relative(0.3 * ratio * ratio + 1e-11 / (ratio * ratio))),
             Quantity("vh/L", ratio) <= 0.5);
  page.claim(
      "its slope against h", slope, "1",
      is(2, "a tangent leaves a circle quadratically", absolute(0.5 * ratio * ratio + 1e-10 / (ratio * ratio))),
      Quantity("vh/L", ratio) <= 0.5);
  page.claim("angular momentum for 1 kg, after a second", momentum, "m²/s",
             is(speed * length, "v·L at the start: the impulse has no lever arm", relative(1e-11)));
  page.claim("length of the rod after a second", radius, "m",
             is(grown, "L(1 + 2v²ht/L²)^¼", relative(ratio * ratio)), Quantity("vh/L", ratio) <= 0.1);
}

}  // namespace byhand::single_constraint
