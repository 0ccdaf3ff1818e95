#include "lessons/02_single_constraint/bob_picture.hpp"
#include "lessons/02_single_constraint/steps.hpp"
#include "lessons/02_single_constraint/within_a_step.hpp"

namespace byhand::single_constraint {

void onto_the_tangent(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row(scene);
  const double length = setting.length(), gain = gravity() * setting.h();
  Pendulum after = scene;
  std::tie(after.state().velocity[0], after.state().velocity[1]) = row.velocities_after();
  const OneRow solved(after);

  const OneRow shown = shown_row(setting);
  const Vector impulse = course::without_rounding(Vector(shown.lambda * shown.d)),
               left = (solved.v2.array().abs() > std::max(1e-10 * gain, 1e-11)).select(solved.v2, 0);
  page.text(
      R"(λ goes back to the bodies by (5). Here it was computed from velocities, so λJᵀ is an *impulse*, a force
      times the time it acts. (*The article calls it a force F; the force is λJᵀ/h.*))");
  page.formula("λd = @·@ = @ N·s on the bob", R"(\lambda\,d = @\cdot @ = @\ \mathrm{N\,s})", shown.lambda, shown.d,
               impulse);
  page.text("Divided by the masses, the impulses change the velocities:");
  page.equation(20, "v₂ = @ + @·@ = @ m/s", R"(v_2 = @ + @\cdot @ = @\ \mathrm{m/s})", shown.v2,
                scene.bodies().inverse_mass[1].linear, impulse, left);
  page.excerpt("solver/row.hpp", "20");

  BobPicture picture(scene);
  const double scale = 0.58 * length / gain;
  const Vector tip = picture.second + scale * row.v2;
  picture.title = "V + M⁻¹Jᵀλ";
  picture.arrows = {
      {picture.second, scale * row.v2, palette::velocity, "V with gravity", 3, renderer::Dash::dashed},
      {tip, scale * (solved.v2 - row.v2), palette::force, "m⁻¹λd"},
      {picture.second, scale * solved.v2, palette::velocity, "V after"}};
  const bool cancels = shown.lambda != 0, moves = left.norm() > 0;
  page.figure("onto_the_tangent",
              cancels && moves ? R"(The impulse takes away the part of V along d and nothing else.)"
              : moves          ? "V lies along the tangent already; the impulse is zero."
                               : "V lies along d; the impulse takes all of it away.",
              [picture](Canvas& canvas) { draw(canvas, {picture}); });

  page.text(R"(JV is now zero to rounding. One formula solves one row *exactly*; nothing is iterated. @)",
            cancels && moves ? "What is left of V is perpendicular to the impulse: λd·V = λJV = 0." : "");

  within_a_step(setting, page);

  const double arrival = std::sqrt(gravity() * length);
  const Pendulum pair = two_free_bobs(setting, Vector(0.9 * arrival, -0.5 * arrival));
  const OneRow hit(pair);
  Pendulum freed = pair;
  std::tie(freed.state().velocity[0], freed.state().velocity[1]) = hit.velocities_after();
  const Vector before_momentum = linear_momentum(pair.bodies()), after_momentum = linear_momentum(freed.bodies());
  BobPicture blow(pair), answer(freed);
  const double per_speed = 1.1 * length / arrival;
  blow.title = "the first bob is struck, the rod reacts";
  const Vector answered = per_speed * hit.lambda * hit.d / setting.mass();
  blow.arrows = {{blow.first, -answered, palette::force, "−λd"},
                 {blow.second, answered, palette::force, "λd"},
                 {blow.first, per_speed * hit.v1, palette::velocity, "v₁"}};
  answer.title = "after: JV = 0";
  answer.arrows = {{answer.first, per_speed * freed.bodies().velocity[0], palette::velocity, "v₁"},
                   {answer.second, per_speed * freed.bodies().velocity[1], palette::velocity, "v₂"}};
  blow.guides = answer.guides = false;
  const Quantity answer_of_rod("λ of two free bobs", hit.lambda, "N·s/m"), struck("their JV", hit.JV, "m²/s");
  page.text(
      R"(−λd acts on the other end of the rod, which does not move here. To see what it does, join two free bobs of @ kg
      and @ kg by the rod and strike the first. @ Their momentum stays @ kg·m/s.)",
      setting.mass(), 4 * setting.mass(),
      page.verdict(
          {{.when = answer_of_rod > 0,
            .say = "It moves towards the second, JV < 0: so λ > 0, and the rod pushes both, equally and in "
                   "opposite directions.",
            .law = struck < 0},
           {.when = answer_of_rod<
                0,
                .say = "It moves away from the second, JV > 0: so λ < 0, and the rod pulls both, equally and in "
                       "opposite directions.",
                .law = struck> 0}}),
      course::without_rounding(after_momentum));
  page.figure(
      "momentum_kept",
      R"(Orange: the two impulses of the rod. The velocities along the rod are equal afterwards, those across it unchanged.)",
      [blow, answer](Canvas& canvas) {
        draw(canvas, {blow, answer});
      });

  page.claim("JV after the impulse", solved.JV, "m²/s", is(0, "(4)", absolute(1e-14 * length * gain)));
  page.claim("speed of the bob after the impulse", solved.v2.norm(), "m/s",
             is(gain * std::sin(radians(setting.angle())), "g·h·sinθ, the part of gravity along the tangent",
                absolute(1e-14 * gain)));
  page.claim("change of momentum of two free bobs", (after_momentum - before_momentum).norm(), "kg·m/s",
             is(0, "action and reaction", absolute(1e-14 * setting.mass() * arrival)));
  const auto spin = [](const Pendulum& bobs) { return angular_momentum(bobs.bodies())[0]; };
  page.claim("change of angular momentum of two free bobs", spin(freed) - spin(pair), "kg·m²/s",
             is(0, "both impulses lie on one line", absolute(1e-14 * setting.mass() * arrival * length)));
}

}  // namespace byhand::single_constraint
