#include "lessons/05_contact/on_a_corner.hpp"
#include "lessons/pictures/acts.hpp"

namespace byhand::contact {
namespace {

/// The box after each row that was solved, and what that row asked for before it was clamped.
struct Solved {
  OnACorner box;
  Point asked;  // (λₜ, λₙ) [N s]
};

Point impulse_of(const OnACorner& box) { return {box.rubbed(), box.pressed()}; }

struct ConeFilm {
  pictures::Acts acts;
  std::vector<Solved> states;    // the first: before any row
  double friction, speed, unit;  // [1], [m/s], the largest impulse [N s]

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.54, 30, 0.8);
    // The impulse so far, and the row that is being solved: first towards what it asks for, then clamped.
    const std::size_t present = acts.now(time);
    Point impulse = impulse_of(states[0].box), velocity = states[0].box.corner_velocity();
    Point asked = impulse;
    if (present > 0) {
      const Solved &from = states[present - 1], &to = states[present];
      const double share = acts.share(present, time);
      const Point before = impulse_of(from.box), after = impulse_of(to.box);
      const bool clamped = (to.asked - after).norm() > 1e-9 * unit;
      const double reach = clamped ? pictures::eased(share / 0.6) : share,
                   back = clamped ? pictures::eased((share - 0.6) / 0.4) : 0;
      asked = before + reach * ((clamped ? to.asked : after) - before);
      impulse = asked + back * (after - asked);
      const double done = share;
      velocity = Point(from.box.corner_velocity()) +
                 done * (Point(to.box.corner_velocity()) - Point(from.box.corner_velocity()));
    }
    canvas.look(fit({-1.35, -0.95, 2.7, 2.6}, left, 6));
    canvas.ground({-1.3, 0}, {1.3, 0});
    const double scale = 1.1 / unit;
    // The cone |λₜ| ≤ μλₙ, as high as the largest impulse.
    const double height = 1.25, half = std::min(friction * height, 1.25);
    const double top = friction > 0 ? half / friction : height;
    canvas.polygon(std::array<Point, 3>{Point(0, 0), Point(half, top), Point(-half, top)},
                   {fade(palette::highlight, 0.25), {palette::highlight, 0}});
    canvas.box(states[0].box.centre(), {1, 1}, radians(tilt), {fade(palette::body, 0.35), {palette::muted, 1.6}});
    for (const double side : {-1.0, 1.0})
      canvas.line({0, 0}, {side * half, top}, {palette::muted, 1.8, Dash::dashed});
    canvas.text({half, top}, "λ_t = μλ_n",
                {.size = 18, .colour = palette::muted, .anchor = Anchor::left, .halo = 3, .offset = {10, -4}});
    if (velocity.norm() > 1e-6 * speed) canvas.arrow({0, 0}, 0.7 / speed * velocity, {palette::velocity, 4});
    if ((asked - impulse).norm() > 1e-6 * unit)
      canvas.arrow({0, 0}, scale * asked, {fade(palette::force, 0.45), 3, Dash::dashed});
    if (impulse.norm() > 1e-6 * unit) canvas.arrow({0, 0}, scale * impulse, {palette::force, 4.5});
    acts.draw(canvas, right, time);
  }
};

std::string at_the_corner(const OnACorner& box, double speed) {
  const double along = without_rounding(box.slip(), speed), up = without_rounding(box.approach(), speed);
  const auto towards = [](double rate, const char* positive, const char* negative) {
    return say("@\u00a0m/s@", Value(std::abs(rate), 2), rate > 0 ? positive : rate < 0 ? negative : "");
  };
  if (along == 0 && up == 0) return "The corner is at rest.";
  if (up == 0) return say("The corner moves at @.", towards(along, " to the right", " to the left"));
  if (along == 0) return say("The corner moves at @.", towards(up, " up", " down"));
  return say("The corner moves at @ and @.", towards(along, " to the right", " to the left"),
             towards(up, " up", " down"));
}

}  // namespace

void within_the_cone(const Setting& setting, bool sticks_without, Page& page) {
  const double speed = setting.speed;
  page.text("Now let the same box also move to the left at @ m/s.", setting.speed);
  OnACorner box(setting.mass, speed, setting.friction(), -speed);
  std::vector<Solved> states{{box, impulse_of(box)}};
  std::vector<pictures::Acts::Act> acts{{"V", at_the_corner(box, speed), palette::velocity}};
  for (int sweep = 1; sweep <= 2; ++sweep) {
    const double rubbed = box.rubbed();
    box.solve_normal();
    states.push_back({box, {rubbed, box.pressed()}});
    acts.push_back({say("λ_n = @ N·s", Value(box.pressed(), 3)),
                    say("The normal's row@. @", sweep == 1 ? "" : " again", at_the_corner(box, speed)),
                    palette::force});
    const double asked = box.rubbed_if_unbounded();
    box.solve_friction();
    states.push_back({box, {asked, box.pressed()}});
    const bool clamped = std::abs(asked - box.rubbed()) > 1e-9 * box.pressed();
    acts.push_back({say("λ_t = @ N·s", Value(without_rounding(box.rubbed(), box.pressed()), 3)),
                    clamped ? say("Friction asks for @ and is clamped to the cone. @", Value(asked, 3),
                                  at_the_corner(box, speed))
                            : say("Friction's row; the cone has room for it. @", at_the_corner(box, speed)),
                    palette::force});
  }
  double unit = 0;
  for (const Solved& state : states) unit = std::max({unit, impulse_of(state.box).norm(), state.asked.norm()});
  const pictures::Acts film(acts);
  page.sequence("within_the_cone",
                say(R"(Two sweeps within one step, slowed to @ s. Orange: the
                    impulse at the corner so far; it stays in the cone |λₜ| ≤ μλₙ (dashed, μ = @). Green: the corner's
                    velocity.)",
                    film.seconds(), setting.friction),
                Seconds{film.seconds()},
                [shown = ConeFilm{film, states, setting.friction(), speed, unit}](Canvas& canvas, double time) {
                  shown.draw(canvas, time);
                });
  for (int sweep = 0; sweep < 60; ++sweep) {
    box.solve_normal();
    box.solve_friction();
  }
  const Quantity slip("slip/speed", std::abs(box.slip()) / speed);
  page.text(
      "@ @", "After many more sweeps nothing changes any more.",
      page.verdict({{.when = slip < 1e-6, .say = "Here too the corner sticks."},
                    {.when = slip >= 1e-6,
                     .say = say(sticks_without ? "This time the corner has more speed to lose than μ = @ can "
                                                 "take: it slips on at @ m/s."
                                               : "With μ = @ it slips here too, at @ m/s.",
                                setting.friction, Value(std::abs(box.slip()), 3))}}));
}

}  // namespace byhand::contact
