// Step 3: friction's row, why JV is computed again for it, and in which order rows are solved.

#include "lessons/05_contact/on_a_corner.hpp"
#include "lessons/05_contact/steps.hpp"
#include "solver/constraints/friction.hpp"

namespace byhand::contact {
namespace {

/// Without what rounding leaves, to three digits.
Value tidy(double value) { return {std::abs(value) < 1e-9 ? 0 : value, 3}; }

/// The velocity of the corner in words, its parts one to a line or beside each other: 3 m/s down.
std::string velocity_in_words(const OnACorner& box, const char* between) {
  std::string words;
  const auto add = [&](double rate, const char* positive, const char* negative) {
    if (std::abs(rate) < 1e-9) return;
    if (!words.empty()) words += between;
    words += say("@ m/s @", tidy(std::abs(rate)), rate < 0 ? negative : positive);
  };
  add(box.slip(), "to the right", "to the left");
  add(box.approach(), "up", "down");
  return words.empty() ? "at rest" : words;
}

/// A box on its corner: how its corner moves, and the impulses so far.
void draw_corner(Canvas& canvas, const OnACorner& box, double speed, double mass, const std::string& words,
                 const Rectangle& frame) {
  // Its words are above and below it, where the frame is low beside it.
  const auto [picture, beside] = frame.split_columns(0.45, 10);
  const bool low = !frame.is_high();
  canvas.look_at_page();
  canvas.text({(low ? beside : frame).centre().x(), frame.top() - (low ? 60 : 24)}, words,
              {.size = 22, .bold = true});
  canvas.text({(low ? beside : frame).centre().x(), frame.y + (low ? 60 : 20)},
              say(low ? "corner:\n@\nω = @ rad/s" : "corner: @\nω = @ rad/s",
                  velocity_in_words(box, low ? ",\n" : ", "), tidy(box.spin())),
              {.size = 18, .anchor = Anchor::bottom});
  const Rectangle below = low ? picture : Rectangle{frame.x, frame.y + 78, frame.width, frame.height - 130};
  canvas.clip(below);
  canvas.look(fit({-1.1, -0.75, 2.2, 2.2}, below, 0));
  canvas.ground({-1.1, 0}, {1.1, 0});
  canvas.box(box.centre(), {1, 1}, radians(tilt));
  const double scale = 0.7 / speed;
  if (box.pressed() > 0)
    canvas.vector({0, 0}, Point(box.rubbed(), box.pressed()), {palette::force, 0.25 / (speed * mass), "N s"});
  if (box.corner_velocity().norm() > 1e-9 * speed)
    canvas.vector({0, 0}, box.corner_velocity(), {palette::velocity, scale, "m/s"});
  canvas.clip({});
  canvas.look_at_page();
}

using Puck = Simulation<PlaneParticle>;

/// A particle that slides on level ground: one contact, one row of friction.
Puck puck(const Setting& setting, const GaussSeidel& solver) {
  Scene<PlaneParticle> scene;
  const int ground = scene.add_body(Linear<PlaneParticle>(0, 0), fixed<PlaneParticle>());
  const int puck =
      scene.add_body(Linear<PlaneParticle>(0, 0), with_mass<PlaneParticle>(setting.mass), {setting.speed, 0});
  const Contact<PlaneParticle> contact{{ground, puck}};
  const auto pressing = scene.add(contact);
  scene.add(Friction<PlaneParticle>{contact.at, tangents_of<PlaneParticle>(contact.normal), setting.friction(),
                                    pressing});
  return {scene, {solver}};
}

struct Order {
  std::string name;
  GaussSeidel solver;
};
const std::array<Order, 4> orders{{
    {"normal first, 1 cold sweep", {.sweeps = 1, .warm_start = false}},
    {"friction first, 1 cold sweep", {.sweeps = 1, .warm_start = false, .order = SweepOrder::reverse}},
    {"friction first, 2 cold sweeps", {.sweeps = 2, .warm_start = false, .order = SweepOrder::reverse}},
    {"friction first, 1 warm sweep", {.sweeps = 1, .warm_start = true, .order = SweepOrder::reverse}},
}};

/// λ of friction in the first step [N s].
double rubbed_in_a_step(const Setting& setting, const GaussSeidel& solver) {
  Puck simulation = puck(setting, solver);
  simulation.step(setting.h);
  return simulation.impulse(1)[0];
}

Chart speeds(const Setting& setting) {
  const double stop = setting.speed / (setting.friction() * gravity);
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "speed (m/s)"}};
  for (std::size_t i = 0; i < orders.size(); ++i) {
    Puck simulation = puck(setting, orders[i].solver);
    Curve curve{.label = orders[i].name,
                .x = {0},
                .y = {setting.speed},
                .style = i == 0 ? CurveStyle::line : CurveStyle::markers};
    const int every = std::max(1, static_cast<int>(stop / setting.h() / 16));
    for (int step = 1; simulation.time < 1.3 * stop; ++step) {
      simulation.step(setting.h);
      if (step % every != static_cast<int>(i) * every / 4) continue;
      curve.x.push_back(simulation.time);
      curve.y.push_back(simulation.scene.bodies().velocity[1].x());
    }
    chart.curves.push_back(std::move(curve));
  }
  return chart;
}

/// Until the particle is at rest, or 2 more than the normal first needs.
int steps_to_stop(const Setting& setting, const GaussSeidel& solver) {
  Puck simulation = puck(setting, solver);
  const int most = static_cast<int>(std::ceil(setting.speed / (setting.friction() * gravity * setting.h()))) + 2;
  int steps = 0;
  while (steps < most && simulation.scene.bodies().velocity[1].x() > 1e-9 * setting.speed) {
    simulation.step(setting.h);
    ++steps;
  }
  return steps;
}

double stopping_distance(const Setting& setting, const GaussSeidel& solver) {
  Puck simulation = puck(setting, solver);
  while (simulation.time < 1.1 * setting.speed / (setting.friction() * gravity) + 2 * setting.h())
    simulation.step(setting.h);
  return simulation.scene.bodies().pose[1].position.x();
}

}  // namespace

void friction_row(const Setting& setting, Page& page) {
  const double mass = setting.mass, speed = setting.speed, mu = setting.friction(), h = setting.h();
  const OnACorner before(mass, speed, mu);
  OnACorner pressed = before;
  pressed.solve_normal();
  OnACorner rubbed = pressed;
  rubbed.solve_friction();
  OnACorner settled = rubbed;
  for (int i = 0; i < 60; ++i) {
    settled.solve_normal();
    settled.solve_friction();
  }

  page.text(
      R"(Friction is (15) once more, with a tangent t in place of n. It has no C to keep at zero; it only asks for JV = 0,
      no slip. Its bound is new: by Coulomb's law friction is at most μ times the normal force, so the bound is another
      row's λ:)");
  page.equation(16);
  page.formula("−μ λₙ ≤ λₜ ≤ μ λₙ", R"(-\mu\,\lambda_n \le \lambda_t \le \mu\,\lambda_n)");
  page.text(
      R"(λₙ is the *accumulated* λ of the contact, and λₜ the accumulated λ of friction. The two rows act at the same
      point of the same body, so why compute JV again for the second? A square box of @ kg and 1 m comes straight down
      on its corner at @ m/s. It is tilted by @°, its centre is to the right of the corner, and it is not rotating: the
      corner moves straight down and does not slip.)",
      setting.mass, setting.speed, tilt);
  const std::string slips =
      say(R"(The push is straight up and passes to the left of the centre, so it turns the box
                                clockwise, and a point below the centre then moves to the left: @ m/s.)",
          Value(std::abs(pressed.slip()), 3));
  page.choose({.ask = "The normal's row stops the corner. Does the corner slip then, and which way?",
               .options = {{"to the left", slips},
                           {"it does not slip", "It did not slip before, but its two directions are coupled."},
                           {"to the right", "It would, if the centre were to the left of the corner."}},
               .answer = pressed.slip() < 0   ? 0
                         : pressed.slip() > 0 ? 2
                                              : 1,
               .hints = {"The push passes beside the centre of mass. What does it do besides stopping the corner?",
                         "It changes ω by I⁻¹(r × n)λ, and the corner's velocity by that ω × r.",
                         "The box turns clockwise. Which way does a point below its centre move?"}});
  page.figure(
      "on_a_corner",
      R"(Left: the corner comes straight down. Middle: the normal's push (orange) has stopped it and made it slip. Right:
      friction has acted on that slip. Green: the corner's velocity.)",
      [=](Canvas& canvas) {
        const auto frames = canvas.page().inset(16).grid(1, 3, 12);
        draw_corner(canvas, before, speed, mass, "before", frames[0]);
        draw_corner(canvas, pressed, speed, mass, "after the normal", frames[1]);
        draw_corner(canvas, rubbed, speed, mass, "after friction", frames[2]);
      });
  page.text(
      R"(So compute JV anew for each row, from the V that the row before has left. That is what *sequential* means in
      sequential impulses: with the old JV friction would have found 0 and given 0, and the corner would slip at @ m/s.
      For the same reason the tangent needs an effective mass of its own. (19) is @/m along n and @/m along t: the
      corner gives way sideways @ times as easily as upwards.)",
      Value(std::abs(pressed.slip()), 3), Value(before.normal_share(mass), 3),
      Value(before.tangent_share(mass), 3), Value(before.tangent_share(mass) / before.normal_share(mass), 3));
  page.derivation(
      "The slip that the normal's impulse makes",
      {{"(17) with b = 0 stops the corner, which came at the rate −v", "λₙ = v/Aₙₙ", R"(\lambda_n = v/A_{nn})"},
       {"that impulse changes the rate along t by Aₜₙ = J_t M⁻¹ J_nᵀ for each unit", "slip = Aₜₙ v/Aₙₙ",
        R"(\text{slip} = \frac{A_{tn}}{A_{nn}}\,v)"},
       {"(19), with r from the centre to the corner", "Aₙₙ = 1/m + rₓ²/I,   Aₜₙ = −rₓ r_y/I",
        R"(A_{nn} = \frac1m + \frac{r_x^2}{I}, \qquad A_{tn} = -\frac{r_x r_y}{I})"}});
  const double lifted = rubbed.approach();
  const Quantity slip("slip left/speed", std::abs(settled.slip()) / speed);
  page.text(
      R"(Friction's push has disturbed the normal in turn: the corner now moves @ at @ m/s. So there is another sweep, and
      another. @)",
      lifted > 0 ? "up" : "down", Value(std::abs(lifted), 3),
      page.verdict(
          {{.when = slip < 1e-6,
            .say = say("In the end both rates are zero: with μ = @ the corner sticks.", setting.friction)},
           {.when = slip >= 1e-6,
            .say = say("In the end nothing changes any more: with μ = @ the bound is too small, and the "
                       "corner slips.",
                       setting.friction)}}));
  within_the_cone(setting, slip.value < 1e-6, page);
  page.text(
      R"(Does the order of the two rows matter? Take a particle of @ kg that slides at
      @ m/s on level ground, μ = @: one contact, one row of friction.)",
      setting.mass, setting.speed, setting.friction);
  const double full = mu * mass * gravity * h, first = rubbed_in_a_step(setting, orders[1].solver);
  const int delay = steps_to_stop(setting, orders[3].solver) - steps_to_stop(setting, orders[0].solver);
  page.choose(
      {.ask =
           "Friction's row first, one sweep a step, started warm. How much later does the particle stop than with "
           "the normal's first?",
       .options =
           {{"not later", "In the first step λₙ is still zero when friction's turn comes, and so is its bound."},
            {"one step later",
             "In the first step λₙ is still zero when friction's turn comes, and so is its bound. Then the warm "
             "start brings the λₙ of the step before."},
            {"it never stops", "So it would if started cold. The warm start brings the λₙ of the step before."}},
       .answer = std::clamp(delay, 0, 2),
       .hints = {"|λₜ| ≤ μ λₙ: what is λₙ when friction's turn comes in the first step?",
                 "With which λₙ does the second step begin?"}});
  page.figure("order_of_rows",
              say("The speed of that particle, from @ m/s with μ = @, by the order of its two rows.",
                  setting.speed, setting.friction),
              speeds(setting));
  page.text(
      R"(With friction first, one cold sweep never slows the particle. A second sweep finds the λₙ of the first, and a
      warm start keeps the λₙ of the step before: both hide the mistake, apart from the delay. With the normals first,
      friction is right from the first sweep. But the row solved last is satisfied best: after friction no normal row
      corrects what friction has disturbed, and bodies may sink a little where they rub. Preventing overlap matters more
      than preventing slip, so Box2D 2 solves the normals last and relies on the warm start; Box2D 3 takes them first
      all the same.)");

  page.measure("slip after the normal's impulse", pressed.slip(), "m/s");
  page.measure("stopping distance", stopping_distance(setting, orders[0].solver), "m");
  const double lever = 6 * std::pow(0.5 * (std::cos(radians(tilt)) - std::sin(radians(tilt))), 2);
  const double moment = -6 * 0.5 * (std::cos(radians(tilt)) - std::sin(radians(tilt))) * 0.5 *
                        (std::cos(radians(tilt)) + std::sin(radians(tilt)));
  page.claim("slip after the normal's impulse", pressed.slip(), "m/s",
             is(speed * moment / (1 + lever), "v·rₓr_y m/I over 1 + rₓ² m/I, by hand", relative(1e-12)));
  page.claim("friction's impulse, friction first, 1 cold sweep", first, "N s",
             is(0, "its bound, μλₙ, is zero", absolute(0)));
  page.claim("friction's impulse, normal first, 1 cold sweep", rubbed_in_a_step(setting, orders[0].solver), "N s",
             is(-full, "−μmgh, against the motion", relative(1e-12)));
  const double steps = speed / (mu * gravity * h);
  // A last step that is not a whole one: f(1 − f)/2 of μgh², f its share.
  page.claim("stopping distance, normal first", stopping_distance(setting, orders[0].solver), "m",
             is(speed * speed / (2 * mu * gravity) - speed * h / 2, "v²/(2μg), less half a step: −vh/2",
                absolute(mu * gravity * h * h / 8 + 1e-9)),
             Quantity("steps", steps) > 4);
}

}  // namespace byhand::contact
