#include <cmath>

#include "lessons/02_single_constraint/bob_picture.hpp"
#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {

using namespace tutor;
using renderer::Canvas;
namespace palette = renderer::palette;

void gravity_first(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row(scene);
  const double length = setting.length(), gain = gravity() * setting.h(), rate = row.JV / length;
  const std::string change = row.JV > 0 ? "grow" : "shrink";

  page.text(
      R"(A bob of @ kg hangs on a rod of @ m. You hold it @° from straight down and let go. In one time step of h =
      @ s nothing but gravity knows that you did: it adds gh to the velocity, straight down.)",
      setting.mass(), length, setting.angle(), setting.h);
  page.excerpt("solver/integrate/euler.hpp", "gravity");
  page.formula("v₂ = (0, −@)·@ = @ m/s", R"(v_2 = (0, -@)\cdot @ = @\ \mathrm{m/s})", gravity(), setting.h,
               row.v2);
  page.text(
      R"(This goes into V *before* anything is solved: the rod can only answer what it is shown.

      Does such a velocity break the rod? Ask Ċ = JV. For two particles the row (14) has two parts left, l₁ = −d
      and l₂ = d with d = P₂ − P₁ = @ m. No arms, no angles, and the held point has v₁ = 0.)",
      row.d);
  page.equation(8, "JV = d·v₂ = @·@ + (@)·(@) = @ m²/s",
                R"(JV = d\cdot v_2 = @\cdot @ + (@)\cdot(@) = @\ \mathrm{m^2/s})", row.d.x(), row.v2.x(),
                row.d.y(), row.v2.y(), row.JV);
  page.excerpt("solver/jacobian.hpp", "8");

  BobPicture picture(scene);
  const double scale = 0.55 * length / gain;
  picture.title = say("JV/|d| = @ m/s", rate);
  picture.arrows = {{picture.second, scale * row.v2, palette::velocity, "V = gh"},
                    {picture.second, scale * rate * row.d / length, palette::error, "JV/|d|"}};
  page.figure("gravity_into_v",
              say(R"(One step of gravity (green) and the part of it along d (purple). Dashed: the way of d, and the
                  tangent that a rigid rod would leave open. If nothing answers, the rod will @ at @ m/s.)",
                  change, std::abs(rate)),
              [picture](Canvas& canvas) { draw(canvas, {picture}); });
  if (std::abs(rate) > 1e-12 * gain)
    page.text("JV is @, not zero. Left alone, the rod would @ by @ m in every second: that is JV divided by |d|.",
              row.JV, change, std::abs(rate));
  else
    page.text(
        "You let go level with the held point, where gravity lies along the tangent: JV is 0 but for rounding.");

  page.claim({.quantity = "JV after gravity",
              .unit = "m²/s",
              .expected = length * gain * std::cos(radians(setting.angle())),
              .source = "L·g·h·cosθ",
              .measured = row.JV,
              .tolerance = absolute(1e-14 * length * gain)});
}

}  // namespace byhand::single_constraint
