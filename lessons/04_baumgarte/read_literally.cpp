// Step 4: (22) as it is printed, without 1/h.

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"

namespace byhand::baumgarte {
namespace {

constexpr double decay_seconds = 10;

Curve decay(const Setting& setting, std::string label, const Baumgarte& cure, int steps, std::size_t every) {
  const std::vector<double> run = errors(setting, cure, setting.h, steps);
  Curve curve{.label = std::move(label), .style = CurveStyle::markers};
  for (std::size_t i = 0; i < run.size(); i += every) {
    curve.x.push_back(static_cast<double>(i) * setting.h);
    curve.y.push_back(100 * std::abs(run[i]));
    if (curve.y.back() < 1e-3 * setting.error) break;
  }
  return curve;
}

}  // namespace

void read_literally(const Setting& setting, Page& page) {
  const double beta = setting.beta(), h = setting.h(), e = setting.error, length = setting.length;
  const int steps = static_cast<int>(std::lround(decay_seconds / h));
  const Baumgarte literal{beta, BetaReading::literal};
  const std::vector<double> run = errors(setting, literal, h, steps);
  const double half = half_life(run[1] / run[0], h), left = run.back() / e;

  page.text("Now read (22) as it is printed:");
  page.equation(22, "JV = −@ s⁻¹ · @ m = @ m/s",
                R"(JV = -@\,\mathrm{s}^{-1}\cdot @\,\mathrm{m} = @\,\mathrm{m/s})", setting.beta, setting.error,
                -beta * e);
  page.text(
      R"(For the units to agree, β must now be a *rate* in 1/s, so it is not "unit-less". A step leaves the share 1 − βh of
      C: for small βh a decay like e^(−βt), whatever the step.)");
  Prediction question{
      .ask =
          say("Read literally, with β = @ s⁻¹: after how many seconds is half of the error gone?", setting.beta),
      .answer = half,
      .unit = "s",
      .tolerance = 0.04 * half,
      .wrong = {{1 / beta, "By then 1/e = 37 % is left; half was gone earlier."},
                {0.5 / beta, "The rate falls as the error falls: e^(−βt), not 1 − βt."}},
      .hints = {"β is now a rate per second, so the number of steps does not matter.", "C = C₀ e^(−βt).",
                say("e^(−βt) = ½, so βt = ln 2 = 0.693: 0.693/@ = …", setting.beta)},
      .hinted = std::log(2) / beta,
      .right = say("ln 2/β = @ s@.", Value(std::log(2) / beta, 3),
                   say("@", Value(half, 3)) == say("@", Value(std::log(2) / beta, 3))
                       ? ""
                       : say("; in steps of @ s, half is gone after @ s", setting.h, Value(half, 3)))};
  if (beta < 1)
    question.wrong.push_back({half_life(1 - beta, h), "Without 1/h, β is a rate per second, not per step."});
  page.predict(question);

  // The first second, in which the correction per step is over, and all of it.
  const auto chart = [&](double end) {
    const int taken = static_cast<int>(std::lround(end / h));
    const Curve law = pictures::theory(
        "e^{−βt}", 0, end, [&](double t) { return 100 * e * std::exp(-beta * t); }, 40);
    return Chart{.x = {.label = "time (s)", .range = {{0, end}}},
                 .y = {.label = "|C| (cm)", .scale = Scale::logarithmic, .range = {{1e-2 * e, 200 * e}}},
                 .curves = {decay(setting, say("as printed: −βC, β = @ s⁻¹", setting.beta), literal, taken,
                                  static_cast<std::size_t>(std::max(1, taken / 40))),
                            decay(setting, say("per step: −(β/h)C, β = @", setting.beta), {beta},
                                  static_cast<int>(std::lround(1 / h)), 1),
                            law}};
  };
  page.figure("literal_and_per_step",
              say("The same number β = @, read in two ways, over @ s; left, the first second. Read literally, @ "
                  "at the end.",
                  setting.beta, decay_seconds,
                  left > 1e-9 ? say("@ % of the error is left", Value(100 * left, 3))
                              : "less than 10⁻⁷ % of the error is left"),
              [first = chart(1), all = chart(decay_seconds)](Canvas& canvas) {
                const auto [early, whole] = canvas.page().inset(12).panels(0.5, 20);
                draw(canvas, first, early);
                draw(canvas, all, whole);
              });
  page.text(
      R"(Both readings are in use; find out which one a program means. Per step the limit is β = 2; as printed it is
      2/h = @ s⁻¹. The solver of this course divides by h, and calls the other reading `BetaReading::literal` (`slop` and `speed_cap`
      are for lesson 5):)",
      2 / h);
  page.excerpt("solver/cures/baumgarte.hpp", "bias");
  page.measure("half-life as printed", half, "s");

  page.claim("half-life as printed", half, "s", is(std::log(2) / beta, "ln 2/β", relative(0.6 * beta * h)));
  page.claim(say("still there after @ s, as printed", decay_seconds), left, "1",
             is(std::pow(1 - beta * h, steps), "(1 − βh)ⁿ", absolute(1e-12 * length / e)));
  for (const double side : {1.99, 2.01})
    page.claim(say("left after fifty steps, β = @ s⁻¹ = @/h", side / h, side),
               std::abs(errors(setting, {side / h, BetaReading::literal}, h, 50).back() / e), "1",
               is(std::pow(side - 1, 50), "|1 − βh|⁵⁰", absolute(1e-11 * length / e)));
}

}  // namespace byhand::baumgarte
