#include "lessons/02_single_constraint/bob_picture.hpp"
#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {

void lambda(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row = shown_row(setting);
  const double length = setting.length(), along = row.lambda * length,
               full = setting.mass() * gravity() * setting.h();
  const bool pulls = row.lambda < 0;

  page.text(
      R"(The rod reacts with an impulse λJᵀ: λd on the bob and −λd on the fixed point. How large is λ, and what is
      its sign?)");
  if (along != 0) {
    const std::string pull = pulls ? "The rod pulls: it keeps itself from getting longer."
                                   : "That rod would pull. JV is negative: without the rod the distance would "
                                     "shrink, so it has to push.",
                      push = pulls ? "That rod would push. JV is positive: without the rod the distance would "
                                     "grow, so it has to pull."
                                   : "The rod pushes: it keeps itself from getting shorter.";
    page.choose(
        {.ask = say("In the first step JV is @. Which way does λd act on the bob, and what is the sign of λ?",
                    pulls ? "positive" : "negative"),
         .options = {{"against d, to the fixed point, with λ < 0", pull},
                     {"against d, with λ > 0", "With λ > 0 the impulse λd points along d."},
                     {"along d, away from the fixed point, with λ > 0", push},
                     {"along d, with λ < 0", "With λ < 0 the impulse λd points against d."}},
         .answer = pulls ? 0 : 2,
         .hints = {say("JV is @: would the rod get longer or shorter?", pulls ? "positive" : "negative"),
                   "The impulse on the bob has to prevent that. d points from the fixed point to the bob.",
                   say("It has to point @, and it is λd.", pulls ? "against d" : "along d")}});
  } else {
    page.text("You let go at the height of the fixed point, where JV is 0: λ is 0 as well.");
  }
  page.text(R"(Afterwards we want JV + b = 0. The bias b is zero until lesson 4.)");
  page.equation(17);
  page.derivation(
      "(17), line by line",
      {{"(5): the impulse is Jᵀλ; divided by the masses it is a change of velocity", "ΔV = M⁻¹Jᵀλ",
        R"(\Delta V = M^{-1}J^T\lambda)"},
       {"wanted: J(V + ΔV) + b = 0", "JV + JM⁻¹Jᵀλ + b = 0", R"(JV + JM^{-1}J^T\lambda + b = 0)"},
       {"JM⁻¹Jᵀ is one number, (19)", "λ = −(JV + b)/(JM⁻¹Jᵀ)", R"(\lambda = -\frac{JV + b}{JM^{-1}J^T})"}});
  if (along != 0)
    page.predict(
        {.ask = say(
             R"(@ kg at @°, at rest, one step of gravity in V (g = @ m/s², h = @ s). λ is in N·s/m; multiply by |d| to
           get the impulse along the rod. How large is λ·|d|, with its sign?)",
             setting.mass(), setting.angle(), gravity(), setting.h),
         .answer = along,
         .unit = "N·s",
         .tolerance = std::min(0.02 * full, 0.2 * std::abs(along)),
         .wrong = {{pulls ? -full : full, "That cancels all of gravity; the rod only cancels the part along d."},
                   {-along, "Look again at the minus in (17) and at the sign of JV."},
                   {row.lambda,
                    say("That is λ itself, in N·s/m. Multiply it by |d| = @ m to get the impulse.", length)}},
         .hints = {"Only the part of gravity along the rod is cancelled. Which angle does the rod make with it?",
                   "(17) times |d|: λ|d| = −(JV/|d|)·m, and JV/|d| is the speed along d.",
                   say("−@ · (@ · @ · cos @°) = …", setting.mass(), gravity(), setting.h, setting.angle())},
         .hinted = -full * std::cos(radians(setting.angle())),
         .right = say("It is −m·g·h·cosθ: m·g·h is @ N·s, and the rod cancels its part along d.", full)});

  page.excerpt("solver/row.hpp", "17");
  page.formula("λ = −(@ + 0) / @ = @ N·s/m, and λ·|d| = @ N·s",
               R"(\lambda = \frac{-(@ + 0)}{@} = @\ \mathrm{N\,s/m}, \qquad \lambda\,|d| = @\ \mathrm{N\,s})",
               row.JV, row.K, row.lambda, along);
  BobPicture row_picture(scene), push(scene);
  const double unit = 0.5 * length;
  row_picture.title = "J: how C increases";
  row_picture.arrows = {{row_picture.second, unit * row.d / length, palette::constraint, "l₂ = d"},
                        {row_picture.first, -unit * row.d / length, palette::constraint, "l₁ = −d"}};
  push.title = say("λJᵀ: λ·|d| = @ N·s", along);
  if (along != 0)
    push.arrows = {
        {push.second, unit * along / full * row.d / length, palette::force, "λ l₂", 4, renderer::Dash::solid, 16},
        {push.first, -unit * along / full * row.d / length, palette::force, "λ l₁", 4, renderer::Dash::solid,
         -16}};
  const Quantity impulse("λ|d|", along, "N·s");
  page.figure(
      "lambda_sign",
      say(R"(Left: the row's arrows, −d and d (drawn shorter), point the way C increases. @@)",
          along != 0 ? "Right: the impulses λJᵀ on the bob and on the fixed point, which does not move. " : "",
          page.verdict({{.when = impulse<0, .say = "λ is negative: the arrows are reversed, and the rod pulls.",
                                         .law = Quantity("JV", row.JV, "m²/s")> 0},
                        {.when = impulse > 0,
                         .say = "λ is positive: the arrows keep the direction of J, and the rod pushes.",
                         .law = Quantity("JV", row.JV, "m²/s") < 0},
                        {.when = impulse == 0, .say = "Right: λ is zero, so there is no impulse."}})),
      [row_picture, push](Canvas& canvas) {
        draw(canvas, {row_picture, push});
      });

  page.claim("λ·|d| of the first step", OneRow(scene).lambda * length, "N·s",
             is(-full * std::cos(radians(setting.angle())), "−m·g·h·cosθ", absolute(1e-14 * full)));
}

}  // namespace byhand::single_constraint
