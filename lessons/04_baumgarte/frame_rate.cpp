// Step 5: a number without unit may still depend on the frame rate.

#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"

namespace byhand::baumgarte {
namespace {

/// Half-life as a run shows it [s].
double measured_half_life(const Setting& setting, double beta, double h) {
  const std::vector<double> run = errors(setting, {beta}, h, 2);
  return half_life(std::sqrt(run[2] / run[0]), h);
}

Chart half_lifes(const Setting& setting, double beta0) {
  const double h0 = setting.h;
  Curve same_beta{.label = say("β = @ fixed", beta0), .style = CurveStyle::markers},
      same_time{.label = "h/β fixed", .style = CurveStyle::markers};
  Curve law_of_beta{.label = "h·ln 2/(−ln(1 − β))", .style = CurveStyle::theory},
      law_of_time{.label = "the same, β ∝ h", .style = CurveStyle::theory};
  for (int cut = 1; cut <= 16; cut *= 2) {
    const double h = h0 / cut;
    for (Curve* curve : {&same_beta, &same_time, &law_of_beta, &law_of_time}) curve->x.push_back(1000 * h);
    same_beta.y.push_back(1000 * measured_half_life(setting, beta0, h));
    same_time.y.push_back(1000 * measured_half_life(setting, beta0 / cut, h));
    law_of_beta.y.push_back(1000 * half_life(1 - beta0, h));
    law_of_time.y.push_back(1000 * half_life(1 - beta0 / cut, h));
  }
  return {.x = {.label = "h (ms)", .scale = Scale::logarithmic},
          .y = {.label = "half-life (ms)", .scale = Scale::logarithmic},
          .curves = {same_beta, same_time, law_of_beta, law_of_time}};
}

}  // namespace

void frame_rate(const Setting& setting, Page& page) {
  const double h = setting.h(), length = setting.length, e = setting.error;
  const bool one_side = setting.beta() <= 0.95;
  // Beyond, the error has no half-life: what follows is then told for a usual β.
  const double beta = one_side ? setting.beta() : 0.2;
  const double half = measured_half_life(setting, beta, h), finer = measured_half_life(setting, beta, h / 2),
               kept = measured_half_life(setting, beta / 2, h / 2);
  const Quantity changes("change of the half-life with h/β kept", std::abs(kept / half - 1));
  const Condition nearly_kept = changes < 0.15;

  if (!one_side)
    page.text(R"(With β = @ @: there is no half-life. This step therefore uses β = 0.2.)", setting.beta,
              setting.beta() < 1    ? "most of the error goes in one step"
              : setting.beta() == 1 ? "the error goes in one step"
              : setting.beta() < 2  ? "the error changes sign in each step as it becomes smaller"
              : setting.beta() == 2 ? "the error changes sign in each step and stays as large"
                                    : "the error changes sign in each step and grows");
  page.text(
      R"(Divided by h, β is a share *per step*. It has no unit, as the article says, and yet its effect depends on the
      number of steps in a second. With β = @ and h = @ s, half of the error is gone after @ ms.)",
      beta, setting.h, Value(1000 * half, 3));
  page.predict(
      {.ask = say("Keep β = @ and halve h. What does the half-life of @ ms become?", beta, Value(1000 * half, 3)),
       .answer = 1000 * finer,
       .unit = "ms",
       .tolerance = 50 * half,
       .wrong = {{1000 * half, "β is a share per step, so the time is proportional to h, and h has changed."},
                 {2000 * half, "The steps are shorter, and each of them still removes the same share."}},
       .hints = {"Count in steps first, then in milliseconds.", "C after k steps = (1 − β)ᵏ C₀.",
                 "It takes the same number of steps. How long does each of them last now?"},
       .hinted = 500 * half,
       .right = "The same number of steps, each half as long."});
  page.formula("half-life = h · ln 2/(−ln(1 − β)) = @ ms",
               R"(t_{1/2} = h\,\frac{\ln 2}{-\ln(1-\beta)} = @\ \mathrm{ms})", 1000 * half);
  page.derivation("The half-life", {{"k steps", "Cₖ = (1 − β)ᵏ C₀", R"(C_k = (1-\beta)^k\,C_0)"},
                                    {"half is left", "(1 − β)ᵏ = ½", R"((1-\beta)^k = \tfrac12)"},
                                    {"logarithm", "k = ln 2/(−ln(1 − β))", R"(k = \frac{\ln 2}{-\ln(1-\beta)})"},
                                    {"each step lasts h", "t = k h", R"(t_{1/2} = k\,h)"},
                                    {"for small β, −ln(1 − β) ≈ β", "t ≈ ln 2 · h/β = 0.69 h/β",
                                     R"(t_{1/2} \approx 0.69\,\frac{h}{\beta})"}});
  page.text(
      R"(For small β the correction has a time constant, h/β (here @ ms). A game tuned at one frame rate and run at another has stiffer or
      softer joints, although nobody touched β. @ with both h and β halved it goes from
      @ ms to @ ms. To keep it exactly, (1 − β)^(1/h) must stay the same: half the step needs β = 1 − √(1 − @) = @.)",
      1000 * h / beta,
      nearly_kept ? "Keeping h/β nearly keeps the half-life:"
                  : "For so large a β, keeping h/β does not keep the half-life:",
      Value(1000 * half, 3), Value(1000 * kept, 3), beta, Value(1 - std::sqrt(1 - beta), 4));
  page.figure("half_life_over_h",
              say("Half-life against time step. With β fixed it is proportional to h (slope 1). @",
                  page.verdict({{.when = changes < 0.15, .say = "With h/β fixed it hardly changes."},
                                {.when = changes < 0.5, .say = "With h/β fixed it changes less."}})),
              half_lifes(setting, beta));
  page.measure("half-life", 1000 * half, "ms");

  const Tolerance rounding = relative(1e-13 * length / e / (beta * (1 - beta)));
  page.claim("half-life", half, "s", is(h * std::log(2) / -std::log1p(-beta), "h·ln 2/(−ln(1 − β))", rounding));
  page.claim("half-life with half the step", finer, "s", is(half / 2, "proportional to h", rounding));
  page.claim("half-life with half the step and 1 − √(1 − β)",
             measured_half_life(setting, 1 - std::sqrt(1 - beta), h / 2), "s",
             is(half, "(1 − β)^(1/h) stays", rounding));
  page.claim("half-life with h/β kept", kept, "s",
             is(std::log(2) * h / beta, "ln 2·h/β; with β halved it falls short by the relative amount β/4",
                relative(0.3 * beta)));
}

}  // namespace byhand::baumgarte
