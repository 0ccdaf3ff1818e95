// Step 2: (21) and (22), where they act alone.

#include "lessons/04_baumgarte/plain_bias.hpp"
#include "lessons/04_baumgarte/plain_figure.hpp"
#include "lessons/04_baumgarte/rod_end.hpp"
#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"
#include "lessons/04_baumgarte/within_two_steps.hpp"

namespace byhand::baumgarte {
namespace {

constexpr int shown_steps = 5;

/// The rod's end at the beginning and after each step, side by side.
void draw_steps(Canvas& canvas, const std::vector<double>& errors) {
  const Rectangle page = canvas.page().inset(24);
  const auto frames = page.cells(1, static_cast<int>(errors.size()), page.is_high() ? 4 : 12);
  double reach = 0;
  for (const double error : errors) reach = std::max(reach, std::abs(error));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Rectangle frame{frames[i].x, frames[i].y, frames[i].width, frames[i].height - 50};
    draw_rod_end(canvas, frame, errors[i], 1.15 * reach, say("@ cm", Value(100 * errors[i], 3)));
    canvas.text({frame.centre().x(), page.top() - 16}, i == 0 ? "at first" : say("step @", i),
                {.size = page.is_high() ? 17.0 : 22.0, .bold = true});
  }
}

}  // namespace

void a_share_of_the_error(const Setting& setting, Page& page) {
  const double beta = setting.beta(), h = setting.h(), e = setting.error, length = setting.length;
  const std::vector<double> run = errors(setting, {beta}, h, shown_steps);
  const bool five = run.size() > shown_steps;  // else a step threw the bob through the anchor
  const double left = five ? without_rounding(run.back(), e) : NAN;

  page.text(
      R"(The cure asks for a rate other than zero. (21) adds a bias b, and (22) chooses b so that the error shrinks:)");
  page.equation(21);
  page.equation(22);
  page.text(
      R"(A step should remove the share β of the error. It lasts h, so the rate must be βC/h; the article prints (22) without
      this 1/h (step 4 is about that). In this course (22) means)");
  page.formula("JV = −(β/h)·C = −(@/(@ s))·@ m = @ m/s",
               R"(JV = -\frac{\beta}{h}\,C = -\frac{@}{@\,\mathrm{s}}\cdot @\,\mathrm{m} = @\,\mathrm{m/s})",
               setting.beta, setting.h, setting.error, -beta * e / h);
  page.text(
      R"(This method is called *Baumgarte stabilisation*. The recipe for one time step:

      - apply gravity to V;
      - write C and J at the present positions;
      - set b = (β/h)C;
      - solve (17) for λ and apply it by (20), so that JV = −(β/h)C;
      - move the bodies by h·V.

      Its only knob is β, the share of the error that one step removes. It corrects *positions* with *velocities*, which
      the bodies keep after the step. The next steps show the consequences.)");
  page.text(
      R"(Watch the correction alone, in weightlessness: a bob at rest on a rod of @ m that is @ m too long. Here C is
      |d| − L, in metres, and J is (14) divided by |d|.)",
      length, e);
  if (five)
    page.predict(
        {.ask = say("The rod is @ cm too long and β = @. How much too long is it after five steps?", 100 * e,
                    setting.beta),
         .answer = 100 * left,
         .unit = "cm",
         .tolerance = 100 * (left == 0 ? 0.015 * e : std::min(0.015 * e, 0.2 * std::abs(left))),
         .wrong = {{100 * e * (1 - shown_steps * beta),
                    "Each step removes a share of the present error, not of the first one."},
                   {100 * e * (1 - beta), "That is the error after the first step; four more follow."}},
         .hints = {"A step lasts h. How far does the bob move in it at the rate JV?",
                   "C′ = C + h·JV with JV = −(β/h)C.",
                   beta == 1 ? "After one step nothing is left to correct."
                   : beta > 1
                       ? say("After one step C = @ cm (the rod is too short); the next step starts from there.",
                             100 * e * (1 - beta))
                       : say("After one step @ cm are left; the next step starts from there.",
                             100 * e * without_rounding(1 - beta, 1))},
         .hinted = 100 * e * std::pow(1 - beta, shown_steps),
         .right = say("Each step leaves the share 1 − β = @, so five leave (1 − β)⁵ = @.",
                      without_rounding(1 - beta, 1), without_rounding(std::pow(1 - beta, shown_steps), 1))});
  else
    page.text(
        R"(With β = @ each step multiplies the error by 1 − β = @. After @ the error is larger than the rod, and the
        bob flies through its anchor.)",
        setting.beta, 1 - beta, several(static_cast<long>(run.size()), "step"));
  page.text(R"(In code, b is one line, and (17) does the rest:)");
  page.excerpt("lessons/04_baumgarte/plain_bias.cpp", "bias");
  page.figure("plain_bias", R"(How this line shrinks an error of 10 cm in steps of 1/60 s, for three β.)",
              chart_of(plain_bias));
  page.figure("five_steps",
              say(R"(The end of the rod, at first and after each of @ with β = @. Dashed: where the bob belongs.)",
                  several(static_cast<long>(run.size()) - 1, "step"), setting.beta),
              [run](Canvas& canvas) { draw_steps(canvas, run); });
  page.text(
      R"(A step with JV = −(β/h)C lasts h, so it moves the bob by h·JV = −βC along the rod. One step therefore
      leaves exactly)");
  if (beta == 1)
    page.formula("C after a step = (1 − β) C before it = 0", R"(C_{k+1} = (1-\beta)\,C_k = 0)");
  else if (beta == 2)
    page.formula("C after a step = (1 − β) C before it = −C", R"(C_{k+1} = (1-\beta)\,C_k = -C_k)");
  else
    page.formula("C after a step = (1 − β) C before it = @ · C", R"(C_{k+1} = (1-\beta)\,C_k = @\; C_k)",
                 1 - beta);
  page.text("On the circle of step 1 the same happens to the drift of every step. Here is one, slowed down:");
  within_two_steps(setting, page);
  const double push = 0.5 * setting.mass * std::pow(beta * e / h, 2);
  const auto returned = [&] {
    if (beta < 1)
      return "Each further step finds a smaller error and asks for less speed, so the energy falls again.";
    if (beta == 1) return "The next step finds no error and stops the bob: the energy is gone again.";
    if (beta < 2) return "Each further step turns the bob round, at a lower speed, so the energy falls again.";
    if (beta == 2) return "Each further step turns the bob round at the same speed: the energy stays.";
    return "Each further step turns the bob round at a higher speed: the energy grows without end.";
  };
  page.text(
      R"(The article calls Baumgarte "a small addition of energy". The bob of this step shows it: it was at rest, and after one
      step it moves at @ m/s and has @ J. @ Step 6 measures the total on a pendulum.)",
      beta * e / h, push, returned());
  if (five) page.measure("error after five steps", 100 * left, "cm");

  page.claim("error after five steps", run.back(), "m",
             is(std::pow(1 - beta, shown_steps) * e, "(1 − β)⁵ of it", absolute(1e-12 * length)),
             Condition{five, "a bob that stays on its side of the anchor"});
  double by_one_line = e;
  for (int step = 0; step < shown_steps; ++step) by_one_line -= h * plain_bias(by_one_line, beta, h);
  page.claim("the same five steps by the one line", by_one_line, "m",
             is(run.back(), "the solver's", absolute(1e-12 * length)),
             Condition{five, "a bob that stays on its side of the anchor"});
  page.claim("the same step with C and J of (2) and (14)", error_in_squared_form(setting), "m",
             is(e * (1 - beta * (length + e / 2) / (length + e)), "½(|d|² − L²)/|d| instead of |d| − L",
                absolute(1e-12 * length)));
  const double moved = (run[1] - run[0]) / h, second = run.size() > 2 ? (run[2] - run[1]) / h : NAN;
  page.claim("energy after the first step", 0.5 * setting.mass * moved * moved, "J",
             is(push, "½m(βC/h)²", relative(1e-13 * length / (beta * e) + 1e-12)));
  page.claim(
      "energy after the second step over that after the first", second * second / (moved * moved), "1",
      is((1 - beta) * (1 - beta), "(1 − β)²: the speed is βC/h", absolute(1e-12 * length / (beta * e) + 1e-12)));
}

}  // namespace byhand::baumgarte
