// Step 6: cold and warm over many steps.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/textbook.hpp"
#include "lessons/laws/closed_forms.hpp"

namespace byhand::iterations {
namespace {

using Chain = Simulation<PlaneParticle>;

/// The hanging chain without a cure for drift, so that only (17) and (20) are at work.
Chain hanging(const Knobs& knobs, bool warm) {
  return {
      rod_chain<PlaneParticle>(knobs.chain()),
      VelocityStepping{.solver = GaussSeidel{.sweeps = knobs.sweeps, .warm_start = warm}, .drift = NoDriftCure{}}};
}

/// How fast each link of a vertical chain is getting longer [m/s].
std::vector<double> stretching(const Chain& chain) {
  std::vector<double> rates;
  for (int bob = 1; bob < chain.scene.bodies().size(); ++bob)
    rates.push_back(chain.scene.bodies().velocity[bob - 1].y() - chain.scene.bodies().velocity[bob].y());
  return rates;
}

double largest(const std::vector<double>& values) {
  double size = 0;
  for (const double value : values) size = std::max(size, std::abs(value));
  return size;
}

/// Largest error [gh] over time, from the first step on.
renderer::Curve error_over_time(std::string label, Chain chain, const Knobs& knobs, double seconds) {
  renderer::Curve curve{.label = std::move(label)};
  while (chain.time < seconds) {
    chain.step(knobs.h);
    curve.x.push_back(chain.time);
    curve.y.push_back(largest(stretching(chain)) / knobs.fall());
    if (curve.y.back() < 1e-14) curve.y.back() = NAN;
  }
  return curve;
}

/// The largest error of such a curve from `begin` [s] on; rounding counts as none.
double largest_from(double begin, const renderer::Curve& curve) {
  double size = 0;
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (curve.x[i] >= begin && curve.y[i] > size) size = curve.y[i];
  return size;
}

/// When [s] such a curve first exceeds a value; infinity if it does not.
double first_beyond(double value, const renderer::Curve& curve) {
  for (std::size_t i = 0; i < curve.x.size(); ++i)
    if (curve.y[i] > value) return curve.x[i];
  return INFINITY;
}

/// What k sweeps leave of the slow wave, q, as a warm chain shows it: its errors obey rₙ₊₁ = q(2rₙ - rₙ₋₁), so
/// rₙ² - rₙ₊₁rₙ₋₁ is multiplied by q in every step. Taken between errors of about 1e-2 and 1e-5, when faster waves
/// have gone.
double measured_q(const Knobs& knobs, double q) {
  const int begin = static_cast<int>(std::ceil(std::log(1e-2) / std::log(std::sqrt(q)))), span = 2 * begin;
  Chain chain = hanging(knobs, true);
  std::vector<double> top{0};
  for (int i = 0; i <= begin + span; ++i) {
    chain.step(knobs.h);
    top.push_back(stretching(chain).front());
  }
  const auto invariant = [&](int n) { return top[n] * top[n] - top[n + 1] * top[n - 1]; };
  return std::pow(invariant(begin + span) / invariant(begin), 1.0 / span);
}

/// The cold chain once its errors have settled.
Chain settled_cold(const Knobs& knobs, double q) {
  Chain chain = hanging(knobs, false);
  const int steps = 10 + static_cast<int>(std::log(1e-10) / std::log(q));
  for (int i = 0; i < steps; ++i) chain.step(knobs.h);
  return chain;
}

void draw_chains(renderer::Canvas& canvas, const Chain& cold, const Chain& warm, double depth, double pitch,
                 const renderer::Rectangle& frame) {
  const auto panels = frame.cells(1, 2, 8);
  const std::pair<const Chain*, const char*> both[] = {{&cold, "cold"}, {&warm, "warm"}};
  for (int i = 0; i < 2; ++i) {
    const auto& [chain, name] = both[i];
    const renderer::Rectangle below{panels[i].x, panels[i].y, panels[i].width, panels[i].height - 40};
    canvas.look_at_page();
    canvas.text({panels[i].centre().x(), panels[i].top() - 16}, name,
                {.size = 24, .colour = palette::series(i), .bold = true});
    const renderer::Camera camera = renderer::fit({-0.1 * depth, -depth, 0.2 * depth, depth + pitch}, below, 6);
    canvas.look(camera);
    canvas.clip(below);
    const double spacing = pitch * camera.scale;
    pictures::draw(canvas, pictures::rods_and_bobs(chain->scene),
                   {.bob = std::min(13.0, 0.3 * spacing),
                    .rod = std::min(5.0, 0.15 * spacing),
                    .bodies = pictures::look_of_run(i)});
    canvas.clip({});
  }
  canvas.look_at_page();
}

}  // namespace

void warm_start(Page& page, const Knobs& knobs) {
  const int k = knobs.sweeps, n = knobs.links;
  const double q = laws::left_by_sweeps(n, k), fall = knobs.fall(), seconds = 3;
  const Condition visible = Quantity("q", q) >= 0.01;
  // λ is kept per metre of a rod that meanwhile changes its length; what that does to √q is of second order in
  // this.
  const double slack = n * Knobs::gravity * knobs.h * knobs.h / knobs.length;
  const Condition lawful = both(visible, Quantity("Ngh²/L", slack) < 0.1);

  page.text(
      R"(A simulation does not sweep until it has converged: it makes k sweeps a step, here @, and moves on. They leave the
      fraction q = ρᵏ@ of the slow wave. Let the chain hang like that for some seconds, without any correction of
      positions, once *cold* (each step begins at λ = 0) and once *warm* (each begins with the λ of the
      last).)",
      k, q < 1e-11 ? say(", less than 10⁻¹¹,") : say(" = @", Value(q, 4)));

  const Chain settled = settled_cold(knobs, visible ? q : 0.01);
  const double rate = largest(stretching(settled));
  // λ belongs to the rod's length before the poses moved on.
  const auto& bodies = settled.scene.bodies();
  const double held = knobs.h * bodies.velocity[1].y() - bodies.pose[1].position.y();
  const double carried = settled.work.system.lambda.front() * -held / knobs.h;
  const bool stretches = rate > 1e-9 * fall;
  const Chain cold = hanging(knobs, false), warm = hanging(knobs, true);
  const renderer::Curve of_cold = error_over_time("cold", cold, knobs, seconds),
                        of_warm = error_over_time("warm", warm, knobs, seconds);
  const double watched = seconds - 0.5;  // from when on errors are compared [s]
  const double most = largest_from(0, of_warm), end = largest_from(watched, of_warm),
               cold_end = largest_from(watched, of_cold), lost_at = first_beyond(1e3, of_warm);
  if (stretches)
    page.choose(
        {.ask = say("@ a step, each step from λ = 0. In the long run, what do the links do?", several(k, "sweep")),
         .options = {{"stop separating", "A cold step forgets λ, but what it leaves stays in V."},
                     {"separate at a steady speed", "The remainder grows until the sweeps remove gh in a step."},
                     {"separate faster and faster",
                      "A larger JV makes the rows pull harder, up to the whole weight."}},
         .answer = 1,
         .hints = {
             "What does a step do with the error that the last one left in V?",
             "The sweeps remove a fixed fraction of what they find. What happens while that is less than gh?"}});
  if (stretches)
    page.text(
        R"(**Cold, the chain keeps getting longer.** The sweeps of every step leave the same fraction of what they find, and
        this remainder stays in V. It grows until what the sweeps remove in a step is exactly gh: in the end the links
        separate at a steady speed, the worst at @ m/s@. The joints then carry the weight (@ N of @ N at the top), but
        only because this speed shows up in every row's JV.)",
        rate,
        cold_end < 0.95 * rate / fall ? say(", or @ gh (after @ s they have reached @ gh)", Value(rate / fall, 2),
                                            seconds, Value(cold_end, 2))
                                      : std::string(),
        carried, knobs.weight());
  else
    page.text(
        R"(**Cold.** @ solve each step to within rounding error, so even without a memory the chain hangs as it should, with
        @ N of @ N at the top. The rest of this step is about fewer sweeps.)",
        several(k, "sweep"), carried, knobs.weight());
  const Quantity compared("warm error/cold error", end / cold_end);
  const auto helps = [&] {
    return page.verdict({{.when = Quantity("error from 2.5 s on/largest error", end / most) < 0.01,
                          .say = "The warm start removes the error."},
                         {.when = both(compared < 1, compared >= 0.5), .say = "The warm start helps a little."},
                         {.when = compared < 0.5, .say = "The warm start helps."},
                         {.when = compared >= 1, .say = "With so few sweeps a warm start takes long to help."}});
  };
  page.text(
      "**Warm, each step begins where the last one stopped.** @",
      !stretches ? std::string("Here that has nothing to add.")
      : std::isfinite(lost_at)
          ? say(R"(Here the chain flies apart after @ s: the links change so much in one step that the λ of the
                last one does not fit.)",
                Value(lost_at, 2))
          : say("From @ to @ s its largest error is @ gh, against @ gh cold. @", watched, seconds,
                small_error(end), Value(cold_end, 2), helps()));
  page.text(
      "For the slow wave, with sₙ the speed of stretching that step n leaves@:",
      slack < 0.1
          ? std::string()
          : say(R"( (this assumes N·g·h² ≪ L; here it is @ L: the rods lengthen noticeably within a step, so last
                              step's λ no longer fits)",
                Value(slack, 2)) +
                ")");
  if (q > 1e-11)
    page.formula("sₙ₊₁ = q (2sₙ − sₙ₋₁),   so |sₙ| falls by √q = @ a step",
                 R"(s_{n+1} = q\,(2s_n - s_{n-1}), \qquad |s_n| \sim \sqrt{q}^{\,n}, \quad \sqrt q = @)",
                 std::sqrt(q));
  else
    page.formula("sₙ₊₁ = q (2sₙ − sₙ₋₁),   so |sₙ| falls by √q a step",
                 R"(s_{n+1} = q\,(2s_n - s_{n-1}), \qquad |s_n| \sim \sqrt{q}^{\,n})");
  page.derivation("What a warm start leaves",
                  {{"step n: V brings sₙ₋₁ and gravity adds g′, the sweeps end with λₙ", "sₙ = sₙ₋₁ + g′ + Aλₙ",
                    R"(s_n = s_{n-1} + g' + A\lambda_n)"},
                   {"step n + 1 begins with sₙ in V and with λₙ", "before its sweeps: sₙ + g′ + Aλₙ = 2sₙ − sₙ₋₁",
                    R"(s_n + g' + A\lambda_n = 2s_n - s_{n-1})"},
                   {"the sweeps multiply it by q", "sₙ₊₁ = q(2sₙ − sₙ₋₁)", R"(s_{n+1} = q(2s_n - s_{n-1}))"},
                   {"try sₙ = zⁿ", "z² − 2qz + q = 0, z = q ± i√(q(1 − q)), |z| = √q",
                    R"(z^2 - 2qz + q = 0, \quad z = q \pm i\sqrt{q(1-q)}, \quad |z| = \sqrt q)"}});
  page.text(
      R"(Each sweep still multiplies the error by ρ. But a warm step begins with 2sₙ − sₙ₋₁, beyond sₙ: on average a warm
      sweep multiplies the wave only by √ρ. Yet warm sweeps add up, and cold ones start again.)");

  constexpr double drawn = 1e-9;  // the least error worth drawing [gh]
  double least = INFINITY;
  for (const renderer::Curve* curve : {&of_cold, &of_warm})
    for (const double error : curve->y) least = std::fmin(least, error);
  const double lowest = std::max(drawn, least / 10);  // on the chart [gh]
  renderer::Chart chart;
  chart.x.label = "time (s)";
  chart.y = {.label = "largest error (gh)", .scale = renderer::Scale::logarithmic, .range = {{lowest, 30}}};
  chart.curves = {of_cold, of_warm};
  renderer::Curve law{.label = "√q a step", .style = renderer::CurveStyle::theory};
  for (double t = 0; t < seconds; t += knobs.h) {
    const double value = std::pow(q, 0.5 * t / knobs.h);
    if (value < lowest) break;
    law.x.push_back(t);
    law.y.push_back(value);
  }
  const bool law_shown = law.x.size() > 1 && slack < 0.1;
  if (law_shown) chart.curves.push_back(law);
  const double worst = std::max(std::min(most, 1e3), largest_from(0, of_cold));
  chart.y.range->second = std::max(3.0, 2 * worst);

  Chain last = cold;
  while (last.time < seconds) last.step(knobs.h);
  const double pitch = knobs.length, depth = 0.6 * pitch - last.scene.bodies().pose.back().position.y();
  if (worst > 10 * drawn)
    page.sequence("cold_and_warm",
                  say(R"(The same chain with @ a step, cold and warm; both began at @ m.
          Right: the largest error over time@.)",
                      several(k, "sweep"), n * knobs.length, law_shown ? ", dashed the law √qⁿ" : ""),
                  Seconds{seconds}, [=, cold = cold, warm = warm](renderer::Canvas& canvas, double time) mutable {
                    while (cold.time < time - 0.5 * knobs.h) {
                      cold.step(knobs.h);
                      warm.step(knobs.h);
                    }
                    const auto [left, right] = canvas.page().inset(16).panels(0.36, 16);
                    draw_chains(canvas, cold, warm, depth, pitch, left);
                    draw(canvas, pictures::grown_to(chart, time), right.lowered(40));
                  });
  else
    page.text("With @ a step neither chain shows an error worth drawing.", several(k, "sweep"));
  const double arrived = std::pow(q, 0.5 / knobs.h);
  if (lawful)
    page.text(
        R"(After one second of warm steps the slow wave is down to @ of where it began. Cold, that would take
        about @ in every step.)",
        small_error(arrived), several(std::max(1L, std::lround(0.5 * k / knobs.h)), "sweep"));
  page.text(
      std::sqrt(q) < 0.05
          ? R"(**The price.** With fewer sweeps the warm error would not just fall but *ring* (in the derivation, the roots z
      are complex). With this many it is gone before it can ring.)"
          : R"(**The price.** The warm error does not just fall, it *rings*: it changes sign again and again on its way down
      (in the derivation, the roots z are complex). Lesson 4, step 6b shows what happens when a correction of positions
      feeds this ringing.)");

  if (stretches) page.measure("largest error of the cold chain", rate / fall, "gh");
  page.claim("warm: what a step leaves of the slow wave", lawful ? std::sqrt(measured_q(knobs, q)) : 0, "1",
             is(lawful ? std::sqrt(q) : 0, "√q, q = cos²ᵏ(π/2N)", relative(1e-5 + slack * slack)), lawful);
  if (visible)
    page.claim("cold: separation speed of the worst link", rate, "m/s",
               is(textbook_cold_errors(knobs.chain(), k, fall).cwiseAbs().maxCoeff(),
                  "(1 − Sᵏ)⁻¹Sᵏ gh, S: the iteration matrix of one sweep", relative(1e-6)),
               visible);
  page.claim("cold: force at the top joint nevertheless", carried, "N",
             is(knobs.weight(), "nothing speeds up any more", relative(1e-6)));
}

}  // namespace byhand::iterations
