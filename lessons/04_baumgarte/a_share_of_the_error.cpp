// Step 2: (21) and (22), where they act alone.

#include <cmath>

#include "lessons/04_baumgarte/rod_end.hpp"
#include "lessons/04_baumgarte/runs.hpp"
#include "lessons/04_baumgarte/steps.hpp"

namespace byhand::baumgarte {
namespace {

using namespace tutor;
using namespace renderer;

constexpr int shown_steps = 5;

/// The rod's end at the beginning and after each step, side by side.
void draw_steps(Canvas& canvas, const std::vector<double>& errors) {
  const Rectangle page = canvas.page().inset(24);
  const auto frames = page.cells(1, static_cast<int>(errors.size()), 12);
  double reach = 0;
  for (const double error : errors) reach = std::max(reach, std::abs(error));
  for (std::size_t i = 0; i < errors.size(); ++i) {
    const Rectangle frame{frames[i].x, frames[i].y, frames[i].width, frames[i].height - 50};
    draw_rod_end(canvas, frame, errors[i], 1.15 * reach, say("@ cm", Value(100 * errors[i], 3)));
    canvas.text({frame.centre().x(), page.top() - 16}, i == 0 ? "at first" : say("step @", i),
                {.size = 22, .bold = true});
  }
}

}  // namespace

void a_share_of_the_error(const Setting& setting, Page& page) {
  const double beta = setting.beta(), h = setting.h(), e = setting.error(), length = setting.length();
  const std::vector<double> run = errors(setting, {beta}, h, shown_steps);
  // Beyond the anchor |d| − L is another error, and n has turned round.
  const bool this_side = std::pow(std::abs(1 - beta), shown_steps) * e < 0.9 * length;
  const std::string range = "a bob that stays on its side of the anchor";

  page.text(
      R"(The cure is to ask for another rate than zero. (21) adds a bias b to it, and (22) chooses b so that the
      error is on its way out:)");
  page.equation(21);
  page.equation(22, "JV = −(β/h)·C = −(@/(@ s))·@ m = @ m/s",
                R"(JV = -\frac{\beta}{h}\,C = -\frac{@}{@\,\mathrm{s}}\cdot @\,\mathrm{m} = @\,\mathrm{m/s})",
                setting.beta, setting.h, setting.error, -beta * e / h);
  page.text(
      R"(You will have noticed a 1/h that is not printed in (22). Without it m/s would stand on one side and m on
      the other; step 4 is about that. In the solver the choice is one line, and (17) does the rest:)");
  page.excerpt("solver/drift.hpp", "bias");
  page.text(
      R"(See it act alone, in weightlessness: a bob at rest on a rod of @ m that is @ m too long. C is |d| − L
      here, in metres, and its J is (14) divided by |d|.)",
      length, e);
  page.predict(
      {.ask = say("The rod is @ cm too long and β = @. By how much after five steps?", 100 * e, setting.beta),
       .answer = 100 * run.back(),
       .unit = "cm",
       .tolerance = 100 * e * 0.015,
       .wrong = {{100 * e * (1 - shown_steps * beta), "It takes away a share of what is left, not of the start."},
                 {100 * e * (1 - beta), "That is after the first step; four more follow."}},
       .hints = {"Each step leaves 1 − β of what it finds."},
       .right = say("(1 − β)⁵ = @ of it is left.", std::pow(1 - beta, shown_steps))});
  page.figure(
      "five_steps",
      say("The end of the rod, at first and after each of five steps with β = @. Dashed: where the bob belongs.",
          setting.beta),
      [run](Canvas& canvas) { draw_steps(canvas, run); });
  page.text(
      R"(A step with JV = −βC/h lasts h and moves the bob by h·JV = −βC along the rod. So what is left is, step by
      step, exactly)");
  page.formula("C after a step = (1 − β) C before it = @ · C", R"(C_{k+1} = (1-\beta)\,C_k = @\; C_k)", 1 - beta);
  const double push = 0.5 * setting.mass() * std::pow(beta * e / h, 2);
  page.text(
      R"(The article calls this "a small addition of energy", and here you can see it: nothing moved, and after one
      step the bob flies at @ m/s and carries @ J. The next step finds less to correct and asks for less speed, and
      so it goes on: what was lent is taken back. Whether that adds up to a gain in a scene that moves is for step
      6 to measure.)",
      beta * e / h, push);
  page.measure("error after five steps", 100 * run.back(), "cm");

  page.claim({.quantity = "error after five steps",
              .unit = "m",
              .expected = std::pow(1 - beta, shown_steps) * e,
              .source = "law B1: (1 − β)⁵",
              .measured = run.back(),
              .tolerance = absolute(1e-12 * length),
              .claimed = this_side,
              .range = range});
  page.claim({.quantity = "the same step with C and J of (2) and (14)",
              .unit = "m",
              .expected = e * (1 - beta * (length + e / 2) / (length + e)),
              .source = "½(|d|² − L²)/|d| instead of |d| − L",
              .measured = error_in_squared_form(setting),
              .tolerance = absolute(1e-12 * length)});
  const double moved = (run[1] - run[0]) / h;
  page.claim({.quantity = "energy lent by the first step",
              .unit = "J",
              .expected = push,
              .source = "½m(βC/h)²",
              .measured = 0.5 * setting.mass() * moved * moved,
              .tolerance = relative(1e-14 * length / (beta * e) + 1e-12)});
}

}  // namespace byhand::baumgarte
