// Step 6: drift, energy and period of a pendulum against β.

#include "lessons/04_baumgarte/pendulums.hpp"
#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/exact/simple_pendulum.hpp"

namespace byhand::baumgarte {
namespace {

constexpr int swings = 3;
constexpr std::array betas{0.01, 0.02, 0.03, 0.05, 0.07, 0.1, 0.15, 0.2, 0.3,
                           0.5,  0.7,  1.0,  1.2,  1.4,  1.6, 1.8,  1.9, 1.95};

constexpr double rounding = 1e-11;  // of a mean energy over mgL, and of a period

/// What a run of some swings gets wrong.
struct Errors {
  double drift = 0;   // largest |C|/L [1]
  double energy = 0;  // mean of the last swing less that of the first, over mgL [1]
  double period = 0;  // relative [1]
};

/// Mean energy in each swing [J]; heights are taken half way through a step, where the velocities of symplectic
/// Euler belong, or their phase would look like energy.
std::vector<double> mean_energies(const Track& run, int steps_a_swing, int count) {
  std::vector<double> means(static_cast<std::size_t>(count), 0.0);
  std::size_t i = 0;
  for (double& mean : means)
    for (int step = 0; step < steps_a_swing; ++step) {
      ++i;
      mean += (run[i].kinetic + (run[i - 1].potential + run[i].potential) / 2) / steps_a_swing;
    }
  return means;
}

/// From the first pass through the lowest point to the third [s].
double measured_period(const Track& run) {
  std::vector<double> passes;
  for (std::size_t i = 1; i < run.size(); ++i) {
    const double before = run[i - 1].position.x(), after = run[i].position.x();
    if (before * after < 0)
      passes.push_back(run[i].time - (run[i].time - run[i - 1].time) * after / (after - before));
  }
  return passes.size() > 2 ? passes[2] - passes[0] : NAN;
}

Errors measure(const Setting& setting, double beta, double period) {
  const double h = setting.h(), length = setting.length;
  const int steps_a_swing = static_cast<int>(std::lround(period / h));
  const Track run = swinging(setting, Baumgarte{beta}, h, swings * steps_a_swing);
  Errors errors;
  for (const Sample& sample : run)
    errors.drift = std::max(errors.drift, std::abs(sample.position.norm() / length - 1));
  const std::vector<double> means = mean_energies(run, steps_a_swing, swings);
  errors.energy = (means.back() - means.front()) / (setting.mass * gravity * length);
  errors.period = measured_period(run) / period - 1;
  return errors;
}

/// What a swing loses of its energy when steps are small, over mgL: the tension T works on a stretch that lags by
/// h(2 − β)/(2β) behind u = v²/L. The loss is h³(2 − β)/(4β²) ∮ Ṫ u̇ dt, with Ṫ u̇ = 6 m g² sin²θ θ̇².
double law_of_loss(const Setting& setting, const SimplePendulum& exact, double beta, double h) {
  double integral = 0;
  constexpr int samples = 400;
  for (int i = 0; i < samples; ++i) {
    const double time = exact.period() * i / samples;
    integral += 6 * std::pow(gravity * std::sin(exact.angle(time)) * exact.angular_velocity(time), 2) / samples;
  }
  return h * h * h * (2 - beta) / (4 * beta * beta) * integral * exact.period() / (gravity * setting.length);
}

/// When the rod of a pendulum is first half as long again, or as short, as it should be [s]; infinity if it never
/// is.
double breaks_at(const Setting& setting, double beta, double period) {
  const int steps = static_cast<int>(swings * period / setting.h());
  for (const Sample& sample : swinging(setting, Baumgarte{beta}, setting.h, steps))
    if (!(std::abs(sample.position.norm() / setting.length - 1) < 0.5)) return sample.time;
  return INFINITY;
}

/// The time in β, h/β, against that of the pendulum [1]: the laws want it small.
double lag(const Setting& setting, double beta) {
  return setting.h() / beta * std::sqrt(gravity / setting.length);
}

/// Those of the curves that have a point.
std::vector<Curve> with_points(std::vector<Curve> curves) {
  std::erase_if(curves, [](const Curve& curve) {
    return std::none_of(curve.y.begin(), curve.y.end(), [](double y) { return std::isfinite(y); });
  });
  return curves;
}

/// The largest stretch, (ωh)²/(2β) where the bob is fastest.
double law_of_drift(const Setting& setting, double beta) {
  const double h = setting.h();
  return gravity * h * h * (1 - std::cos(radians(setting.release()))) / (beta * setting.length);
}

}  // namespace

void what_it_costs(const Setting& setting, Page& page) {
  const double length = setting.length, h = setting.h(), beta = setting.beta();
  const SimplePendulum exact(radians(setting.release()), length, gravity);
  const double period = exact.period();

  const double breaks = breaks_at(setting, beta, period);
  if (std::isfinite(breaks))
    page.text("With β = @ the rod does not even roughly keep its length: after @ s it is off by half of it.",
              setting.beta, Value(breaks, 3));
  const auto compared = film_betas(setting);
  page.text(
      R"(Now with gravity: release three pendulums from @°, one without correction, one with β = @@ and one with β = @.)",
      setting.release(), Value(compared[1]),
      compared[1] == beta     ? ""
      : std::isfinite(breaks) ? " instead"
                              : " for comparison",
      Value(compared[2]));
  page.sequence(
      "three_pendulums",
      R"(In colour: the article's step; dashed: the exact pendulum. Below: the size of each rod's error.)",
      Seconds{film_seconds},
      [film = PendulumFilm(setting)](Canvas& canvas, double time) { film.draw(canvas, time); });

  Curve drift{.label = "largest |C|/L", .style = CurveStyle::line_and_markers, .colour = palette::error},
      energy{.label = "lost energy/mgL", .style = CurveStyle::line_and_markers, .colour = palette::series(5)},
      time{.label = "|period error|", .style = CurveStyle::line_and_markers, .colour = palette::series(7)},
      drift_law{.label = "(ωh)²/2β", .style = CurveStyle::theory},
      energy_law{.label = "law of the loss", .style = CurveStyle::theory};
  double before = 0;  // the period's error at the last β
  std::string turns;  // each β where its sign changes, in words
  double most = -INFINITY, best_drift = 0, best_energy = 0, best_period = 0;
  std::array<double, 3> least{1e300, 1e300, 1e300};
  for (const double b : betas) {
    const Errors errors = measure(setting, b, period);
    for (Curve* curve : {&drift, &energy, &time, &drift_law, &energy_law}) curve->x.push_back(b);
    drift.y.push_back(errors.drift);
    energy.y.push_back(errors.energy < -rounding ? -errors.energy : NAN);
    time.y.push_back(std::abs(errors.period) > rounding ? std::abs(errors.period) : NAN);
    const bool quick = lag(setting, b) <= 0.3;
    drift_law.y.push_back(quick ? law_of_drift(setting, b) : NAN);
    const double lost = (swings - 1) * law_of_loss(setting, exact, b, h);
    energy_law.y.push_back(quick && lost > rounding ? lost : NAN);
    most = std::max(most, errors.energy);
    if (before * errors.period < 0)
      turns += (turns.empty() ? "" : " and ") +
               say("@", std::abs(before) < std::abs(errors.period) ? drift.x.end()[-2] : b);
    before = errors.period;
    const std::array found{errors.drift, std::abs(errors.energy), std::abs(errors.period)};
    const std::array best{&best_drift, &best_energy, &best_period};
    for (std::size_t i = 0; i < 3; ++i)
      if (found[i] < least[i]) {
        least[i] = found[i];
        *best[i] = b;
      }
  }

  const bool loses = most <= rounding;
  page.choose(
      {.ask = say(
           R"(The article calls Baumgarte an addition of energy, and in weightlessness it did add some. Does the
                  pendulum gain or lose energy from the first swing to the third, for β from @ to @?)",
           betas.front(), betas.back()),
       .options =
           {{"it gains, for all of these β",
             R"(The correction pulls the bob in only as far as earlier steps let it out, and later, when the
                    tension is a little smaller.)"},
            {"it loses, for all of these β",
             loses ? R"(Moving out, the bob works against the tension; pulled back in, it gets that work back. But
                            the stretch lags some steps behind the tension, so the rod lengthens under a slightly
                            larger tension than it shortens under.)"
                   : "Not here: with so few steps a swing, or so small a swing, some β gain."},
            {"it gains for some and loses for others",
             loses ? "How much it loses depends strongly on β. The sign does not."
                   : "With so few steps a swing, or so small a swing, the sign depends on β."}},
       .answer = loses ? 1 : 2,
       .hints = {"Without correction it lost. Does the correction add more than it takes back?",
                 "The tension T does the work −∮ T Ċ dt over a swing.",
                 "The stretch C follows the speed, but some steps late."}});
  const bool left_out = std::any_of(energy.y.begin(), energy.y.end(), [](double y) { return std::isnan(y); });
  page.figure(
      "cost_of_beta",
      say(R"(Largest drift, energy lost from the first swing to the third, and period error against β, for a pendulum
          released from @° with h = @ s. Dashed: the laws for small steps. @)",
          setting.release(), setting.h,
          left_out ? "(Points where it gained, or changed by rounding only, are left out.)" : ""),
      Chart{.x = {.label = "β", .scale = Scale::logarithmic},
            .y = {.label = "error", .scale = Scale::logarithmic},
            .curves = with_points({drift, energy, time, drift_law, energy_law})});
  page.text(
      "@ @ @",
      best_drift == betas.back() && best_energy == betas.back()
          ? say("The drift and the lost energy keep falling up to the end of the range, β = @.", betas.back())
          : say("Of these β, up to @, the drift is least at @ and the loss of energy at @.", betas.back(),
                best_drift, best_energy),
      turns.empty() ? "" : say("(The period error dips near β = @ only because it changes sign there.)", turns),
      page.verdict({{.when = where(Quantity("best β for drift", best_drift) > 0.3,
                                   Quantity("best β for energy", best_energy) > 0.3,
                                   Quantity("the most energy gained", most, "mgL") <= rounding),
                     .say = "On *one* row, solved exactly, a large β costs little, and the usual 0.1 to 0.3 is "
                            "cautious."}}));
  page.text(
      R"(A large β has its price elsewhere:

      - A sudden error is removed at the speed βC/h: for @ cm that is @ m/s with β = 1@.
      - Beyond 1 the correction of a sudden error overshoots, and the next step has to turn the bob round.
      - Where rows are *not* solved exactly, the limit can be far below 2: step 6b shows it.)",
      100 * setting.error, setting.error / h,
      beta == 1 ? "" : say(", and @ m/s with β = @", beta * setting.error / h, setting.beta));
  page.text(
      R"(How much energy does one swing, there and back, cost? (The figure shows two of them.) With the rod's tension T and
      the centripetal acceleration u = v²/L, small steps change the energy per swing by)");
  page.formula("ΔE ≈ −h³(2 − β)/(4β²) · ∮ Ṫ u̇ dt",
               R"(\Delta E \approx -\frac{h^3(2-\beta)}{4\beta^2}\oint \dot T\,\dot u\,dt)");
  page.derivation(
      "Where the energy goes",
      {{"each step adds ½h²u to C, and removes βC", "C′ = (1 − β)C + ½h²u",
        R"(C' = (1-\beta)\,C + \tfrac12 h^2 u)"},
       {"of the drift that was added j steps ago the share (1 − β)ʲ is left, so the drift in C is on average "
        "(1 − β)/β steps old, and half a step more, because each drift builds up during its step; if u changes "
        "little within h/β, C follows u with the delay τ",
        "C(t) = h²/(2β) · u(t − τ),   τ = h(1 − β)/β + h/2 = h(2 − β)/(2β)",
        R"(C(t) = \frac{h^2}{2\beta}\,u(t-\tau),\qquad \tau = h\,\frac{1-\beta}{\beta} + \frac h2 = \frac{h(2-\beta)}{2\beta})"},
       {"the rod pulls inward with T, so over a swing it does the work", "W = −∮ T Ċ dt",
        R"(W = -\oint T\,\dot C\,dt)"},
       {"T and u depend on the angle alone, so ∮ T u̇ dt = 0; the delay leaves",
        "W = h²/(2β) · τ ∮ T ü dt = −h²/(2β) · τ ∮ Ṫ u̇ dt",
        R"(W = \frac{h^2}{2\beta}\,\tau\oint T\,\ddot u\,dt = -\frac{h^2}{2\beta}\,\tau\oint \dot T\,\dot u\,dt)"},
       {"T = m(u + g cos θ), u̇ = −2g sin θ θ̇", "Ṫ u̇ = 6 m g² sin²θ θ̇² ≥ 0",
        R"(\dot T\,\dot u = 6\,m\,g^2\sin^2\theta\,\dot\theta^2 \ge 0)"},
       {"so W has the sign of −(2 − β): a loss for every β below 2", "W = −h³(2 − β)/(4β²) ∮ Ṫ u̇ dt",
        R"(W = -\frac{h^3(2-\beta)}{4\beta^2}\oint \dot T\,\dot u\,dt)"}});

  if (std::isinf(breaks)) {
    const Errors own = measure(setting, beta, period);
    page.measure("largest drift", 1000 * own.drift, "mm per m");
    page.measure("energy change, first to third swing", without_rounding(own.energy, 1), "mgL");
    page.measure("error of the period", 100 * without_rounding(own.period, 1), "%");
  }

  const Condition wide = within(30, Quantity("release", setting.release, "°"), 120),
                  usual = both(wide, Quantity("steps of a swing", period / h) >= 100);
  page.claim(say("largest energy change of any β from @ to @", betas.front(), betas.back()), most, "mgL",
             is_at_most(rounding, "ΔE < 0 for β < 2, but for rounding"), usual);
  const double behind = lag(setting, beta);
  const Condition near = where(Quantity("h/β·√(g/L)", behind) <= 0.3, Quantity("β", beta) <= 1, usual);
  page.claim("largest drift, over L", near ? measure(setting, beta, period).drift : 0, "1",
             is(law_of_drift(setting, beta), "(ωh)²/(2β) at the lowest point (step 6a)",
                relative(0.05 + 2 * behind * behind)),
             near);
  const double own_beta = beta >= 0.2 && beta <= 1.9 ? beta : 0.2;
  constexpr int fine = 1500;
  const std::vector<double> means =
      mean_energies(swinging(setting, Baumgarte{own_beta}, period / fine, 2 * fine), fine, 2);
  page.claim(say("energy that one swing of @ steps loses, β = @", fine, own_beta),
             (means[0] - means[1]) / (setting.mass * gravity * length), "mgL",
             is(law_of_loss(setting, exact, own_beta, period / fine), "h³(2 − β)/(4β²)·∮ Ṫu̇ dt", relative(0.01)),
             wide);
}

}  // namespace byhand::baumgarte
