// Deeper: springs as rows that give way.

#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/spring.hpp"

namespace byhand::joints {
namespace {

using Hanging = Simulation<PlaneParticle>;

/// A bob on a spring that is tuned to it by frequency [rad/s] and damping ratio, and below it, on a rod, a load of
/// `load` bobs' weight if that is not zero.
Hanging on_spring(const Setting& setting, double frequency, double damping_ratio, double load) {
  const double length = setting.length, mass = setting.mass;
  Hanging hanging{{}, {.solver = Direct{}, .drift = Baumgarte{1}}};
  auto& scene = hanging.scene;
  scene.add_body(Linear<PlaneParticle>(0, 0), fixed<PlaneParticle>());
  scene.add_body(Linear<PlaneParticle>(0, -length), with_mass<PlaneParticle>(mass));
  Spring<PlaneParticle> spring{{0, 1}, length};
  spring.elastic = tuned(scene.bodies(), spring, frequency, damping_ratio);
  scene.add(spring);
  if (load > 0) {
    scene.add_body(Linear<PlaneParticle>(0, -2 * length), with_mass<PlaneParticle>(load * mass));
    scene.add(NormalisedDistance<PlaneParticle>{{1, 2}, length});
  }
  return hanging;
}

double stretch(const Hanging& hanging, double length) {
  return hanging.scene.bodies().pose[1].position.norm() - length;
}

/// How far it hangs out once it has come to rest [m].
double sag(const Setting& setting, double frequency, double load) {
  Hanging hanging = on_spring(setting, frequency, 1, load);
  const double time = 40 * (1 + load) / frequency + 50 * setting.h;
  advance_to(hanging, time, setting.h);
  return stretch(hanging, setting.length);
}

}  // namespace

void soft_rows(const Setting& setting, Page& page) {
  const double h = setting.h(), length = setting.length, heavy = 10, shown = 20;  // load [1], ω [rad/s]
  page.text(
      R"(Let a row give way on purpose. Ask for the impulse of a spring and a damper, λ/h = −(kC + cĊ), both taken at the
      *end* of the step, where C has become C + h JV. Solve for JV, and you have a row again, with a bias and a softness
      γ:)");
  page.formula("JV + (k/(c + hk)) C + γλ = 0,   γ = 1/(h(c + hk))",
               R"(JV + \frac{k}{c + hk}\,C + \gamma\lambda = 0, \qquad \gamma = \frac{1}{h(c + hk)})");
  page.derivation("A spring and a damper as a row",
                  {{"force of spring and damper at the step's end", "λ/h = −k(C + hJV) − c JV",
                    R"(\lambda/h = -k\,(C + hJV) - c\,JV)"},
                   {"collect JV", "(c + hk) JV + kC + λ/h = 0", R"((c + hk)\,JV + kC + \lambda/h = 0)"},
                   {"divide by c + hk", "JV + k/(c + hk) C + γλ = 0,   γ = 1/(h(c + hk))",
                    R"(JV + \frac{k}{c+hk}\,C + \gamma\lambda = 0,\qquad \gamma = \frac{1}{h(c+hk)})"}});
  page.text(
      R"(Instead of k and c, give a frequency ω and a damping ratio ζ, and take k = m ω² and c = 2mζω with the row's own
      effective mass m = 1/A of (19). A spring that only carries its own bob then stretches by g/ω², whatever the bob's
      mass. But m is the mass that *this row* sees, not the mass that hangs below it.)");
  page.text(
      R"(**Soft constraints** use this in place of Baumgarte's β, for every row. The recipe:

      - apply gravity to V;
      - solve the rows with this bias and this γ (ω about 90 rad/s, ζ = 1);
      - move the bodies by h·V;
      - solve the rows again, hard and without bias: this relaxes them, JV = 0;
      - keep that λ, which contains no correction, for the next warm start.

      The knobs are ω and ζ. One row is stable for every ωh and ζ, and the relaxed λ does not ring as in lesson 4. The
      price is a second solve. A soft row stretches under load, so it cannot hold a heavy load on a light body exactly;
      and with few sweeps on a long chain it has a limit of its own (lesson 8).)");
  const double light = sag(setting, shown, 0), loaded = sag(setting, shown, heavy);
  page.predict(
      {.ask = say(
           R"(At ω = @ rad/s the bob stretches the spring by @ mm. Now hang a bob of @ times its mass below it. How far
                  does the spring stretch?)",
           shown, Value(1000 * light, 3), heavy),
       .answer = 1000 * loaded,
       .unit = "mm",
       .tolerance = 200 * light,
       .wrong = {{1000 * light,
                  "The spring was tuned to its own bob. Now its load is larger, but its stiffness is not."},
                 {1000 * heavy * light, "It still carries its own bob too."}},
       .hints = {"The stiffness was chosen for the first bob. What does the spring carry now?",
                 "C = T/k, and k = m ω² with the first bob's m.",
                 say("T is @ times as large: @ · @ mm = …", heavy + 1, heavy + 1, Value(1000 * light, 3))},
       .right = "C = T/(mω²), and T is the weight of both."});
  Chart sags{.x = {.label = "ω (rad/s)", .scale = Scale::logarithmic},
             .y = {.label = "stretch (m)", .scale = Scale::logarithmic}};
  for (const double load : {0.0, heavy}) {
    Curve measured{.label = load == 0 ? "bob alone" : say("and @ more below", load), .style = CurveStyle::markers},
        law{.label = load == 0 ? "T/(mω²)" : "", .style = CurveStyle::theory};
    for (const double frequency : {5.0, 10.0, 20.0, 50.0, 100.0, 300.0, 1000.0}) {
      measured.x.push_back(frequency);
      measured.y.push_back(sag(setting, frequency, load));
      law.x.push_back(frequency);
      law.y.push_back(gravity * (1 + load) / (frequency * frequency));
    }
    sags.curves.push_back(measured);
    sags.curves.push_back(law);
  }

  Chart rings{.x = {.label = "step"}, .y = {.label = "stretch / initial stretch"}};
  double worst = 0;
  for (const double turn : {0.1, 0.5, 2.0, 10.0}) {
    Hanging hanging = on_spring(setting, turn / h, 0, 0);
    hanging.scene.gravity.setZero();
    const double begin = 0.05 * length, k = hanging.scene.all<Spring>()[0].elastic.stiffness;
    hanging.scene.set_position(1, {0, -length - begin});
    Curve curve{.label = say("ωh = @", turn), .x = {0}, .y = {1}};
    double energy = 0.5 * k * begin * begin;
    for (int i = 1; i <= 100; ++i) {
      hanging.step(h);
      const double C = stretch(hanging, length),
                   now = 0.5 * k * C * C + 0.5 * setting.mass * hanging.scene.bodies().velocity[1].squaredNorm();
      worst = std::max(worst, now / energy);
      energy = std::max(now, 1e-12);
      curve.x.push_back(i);
      curve.y.push_back(C / begin);
    }
    rings.curves.push_back(curve);
  }
  page.figure(
      "soft_rows",
      R"(Left: the stretch of a spring tuned to its own bob; points are runs, dashed the law. Right: a spring
      without damping, pulled out and let go. The step itself damps it, a stiff spring more than a weak one.)",
      [sags, rings](Canvas& canvas) {
        const Rectangle paper = canvas.page();
        const auto cells = paper.inset(14, paper.is_high() ? 14 : 60).grid(1, 2, 24);
        draw(canvas, sags, cells[0]);
        draw(canvas, rings, cells[1]);
      });
  page.text(
      R"(As an explicit force, stepped by symplectic Euler, a spring becomes unstable beyond ωh = 2. This row does not,
      for any k, c and h, as long as it is solved exactly. It loses energy instead: at ωh = 2 the motion is gone within
      one swing. A spring that is meant to swing needs ωh well below 1; a spring that is only meant to be *firm* may be
      as stiff as you like, and you know its stretch beforehand.)");
  page.claim("stretch with the bob alone", light, "m",
             is(gravity / (shown * shown), "law of the soft row: T/(m_eff ω²) = g/ω²", relative(1e-6)));
  page.claim(say("stretch with @ times its mass below", heavy), loaded, "m",
             is(gravity * (1 + heavy) / (shown * shown), "law of the soft row: T/(m_eff ω²)", relative(1e-4)));
  page.claim("energy after a step over before, at most, ωh up to 10", worst, "1",
             is_at_most(1 + 1e-9, "implicit Euler never gains"));
}

}  // namespace byhand::joints
