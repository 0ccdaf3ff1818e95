#include "lessons/02_single_constraint/bob_picture.hpp"
#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {
namespace {

std::string held(double degrees) {
  if (degrees == 0) return "straight below the fixed point";
  if (std::abs(degrees) == 180) return "straight above the fixed point";
  return say("at @° from straight down", degrees);
}

}  // namespace

void gravity_first(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row = shown_row(setting);
  const double length = setting.length(), gain = gravity() * setting.h(), rate = row.JV / length;

  page.text(
      R"(A bob of @ kg sits at the end of a rod of @ m. You hold it @ and let go. In one time step of h = @ s gravity adds gh
      to its velocity, straight down.)",
      setting.mass(), length, held(setting.angle()), setting.h);
  page.excerpt("solver/integrate/euler.hpp", "gravity");
  page.formula("v₂ = (0, −@)·@ = @ m/s", R"(v_2 = (0, -@)\cdot @ = @\ \mathrm{m/s})", gravity(), setting.h,
               row.v2);
  page.text(
      R"(Gravity goes into V *before* anything is solved, because the constraint can only cancel what is already in V.

      How fast would C change with this V? At the rate Ċ = JV (lesson 1); JV/|d| is how fast the rod would change its length. Body 1 is the fixed point,
      body 2 the bob. Neither turns, so two parts of the row (14) remain, l₁ = −d and l₂ = d with d = P₂ − P₁ = @ m.
      The fixed point has v₁ = 0.)",
      row.d);
  const auto factor = [](double value) {  // in brackets if negative
    if (value >= 0) return Value(value);
    const Formula bracketed = fill("(@)", "(@)", {Value(value)});
    return Value(bracketed.plain, bracketed.latex);
  };
  page.formula("JV = d·v₂ = @·@ + @·@ = @ m²/s", R"(JV = d\cdot v_2 = @\cdot @ + @\cdot @ = @\ \mathrm{m^2/s})",
               row.d.x(), row.v2.x(), factor(row.d.y()), factor(row.v2.y()), row.JV);

  BobPicture picture(scene);
  const double scale = 0.55 * length / gain;
  picture.title = say("JV/|d| = @ m/s", rate);
  picture.arrows = {{picture.second, scale * row.v2, palette::velocity, "V = gh"},
                    {picture.second, scale * rate * row.d / length, palette::error, "JV/|d|"}};
  page.figure(
      "gravity_into_v",
      say(R"(One step of gravity (green) and its part along d (purple)@. Dashed: the line of d, and the tangent,
                  along which a rigid rod lets the bob move.)",
          rate == 0 ? ", which is zero here" : ""),
      [picture](Canvas& canvas) { draw(canvas, {picture}); });
  const Quantity growth("JV/|d|", rate, "m/s"), along("cos θ", std::cos(radians(setting.angle())));
  page.text("JV is @ m²/s; divided by |d| it is @ m/s. @", row.JV, rate,
            page.verdict(
                {{.when = growth > 0,
                  .say = "At this rate the rod would get longer if it exerted no force on the bob.",
                  .law = along > 0},
                 {.when = growth < 0,
                  .say = "At this rate the rod would get shorter if it exerted no force on the bob.",
                  .law = along < 0},
                 {.when = growth == 0,
                  .say = "You let go at the height of the fixed point, where gravity lies along the tangent."}}));

  page.claim(
      "JV after gravity", OneRow(scene).JV, "m²/s",
      is(length * gain * std::cos(radians(setting.angle())), "L·g·h·cosθ", absolute(1e-14 * length * gain)));
}

}  // namespace byhand::single_constraint
