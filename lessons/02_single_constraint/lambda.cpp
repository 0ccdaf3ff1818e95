#include <cmath>

#include "lessons/02_single_constraint/bob_picture.hpp"
#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {

using namespace tutor;
using renderer::Canvas;
namespace palette = renderer::palette;

void lambda(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row(scene);
  const double length = setting.length(), along = row.lambda * length,
               full = setting.mass() * gravity() * setting.h();
  const bool pulls = row.lambda < 0;

  page.text(
      R"(Now (17): the one number λ with which JV becomes 0. There is no bias yet, b = 0. First its sign, and that
      without any arithmetic: JM⁻¹Jᵀ is a sum of squares, so only JV decides.)");
  page.equation(17);
  if (std::abs(along) > 1e-12 * full) {
    const std::string
        toward = "The push on the bob is λd. With λ < 0 it points against d, to the held point: the rod pulls.",
        away =
            "The push on the bob is λd. With λ > 0 it points along d, away from the held point: the rod pushes.";
    page.choose(
        {.ask = say(R"(J's arrow on the bob is d: it points away from the held point, where C grows. Gravity has
                    just made JV @. Which sign has λ?)",
                    pulls ? "positive" : "negative"),
         .options = {{"negative", toward}, {"positive", away}},
         .answer = pulls ? 0 : 1,
         .hints = {"The minus in (17) turns it round."}});
  } else {
    page.text(
        "You have put the bob level with the held point, where JV is 0 but for rounding: λ has nothing to do.");
  }

  page.predict(
      {.ask = say(
           R"(@ kg at @°, at rest, one step of gravity already in V. λ counts per metre of d; times |d| it is an
           impulse. How large is λ·|d|, with its sign?)",
           setting.mass(), setting.angle()),
       .answer = along,
       .unit = "N·s",
       .tolerance = 0.02 * full,
       .wrong = {{-full, "You stopped all of gravity; the rod only stops the part along J."},
                 {along / setting.h(), "That is λ/h, a force."},
                 {-along, "J points away from the held point; look once more at which way this rod acts."},
                 {row.lambda, "That is λ itself, in N·s/m: (14) is not divided by |d|."}},
       .hints = {"JV over |d| is the speed along d. Which mass has to lose it?"},
       .right = say("m·g·h is @ N·s; the rod answers for its part along d.", full)});

  page.formula("λ = −(@ + 0) / @ = @ N·s/m, and λ·|d| = @ N·s",
               R"(\lambda = \frac{-(@ + 0)}{@} = @\ \mathrm{N\,s/m}, \qquad \lambda\,|d| = @\ \mathrm{N\,s})",
               row.JV, row.K, row.lambda, along);
  page.excerpt("solver/row.hpp", "17");

  BobPicture row_picture(scene), push(scene);
  const double unit = 0.5 * length;
  row_picture.title = "J: where C grows";
  row_picture.arrows = {{row_picture.second, unit * row.d / length, palette::constraint, "l₂ = d"},
                        {row_picture.first, -unit * row.d / length, palette::constraint, "l₁ = −d"}};
  push.title = say("λJᵀ: λ·|d| = @ N·s", along);
  push.arrows = {{push.second, unit * along / full * row.d / length, palette::force, "λ l₂"},
                 {push.first, -unit * along / full * row.d / length, palette::force, "λ l₁"}};
  page.figure(
      "lambda_sign",
      R"(Left: the row's two arrows point away from the rod, where C grows (drawn shorter than they are). Right:
      the impulses λJᵀ on the bob and on the held point, which has the mass of the world behind it and does not
      notice. The minus in (17) has turned them round wherever JV is positive.)",
      [row_picture, push](Canvas& canvas) {
        draw(canvas, {row_picture, push});
      });
  page.text(
      R"(The article says that J "points towards the target". It does not: a gradient points where C *grows*, and
      the minus in (17) does the rest.)");

  page.claim({.quantity = "λ·|d| of the first step",
              .unit = "N·s",
              .expected = -full * std::cos(radians(setting.angle())),
              .source = "−m·g·h·cosθ",
              .measured = along,
              .tolerance = absolute(1e-14 * full)});
}

}  // namespace byhand::single_constraint
