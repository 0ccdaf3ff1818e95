#include "lessons/02_single_constraint/within_a_step.hpp"

#include "lessons/pictures/acts.hpp"

namespace byhand::single_constraint {
namespace {

struct StepFilm {
  pictures::Acts acts;
  OneRow row;
  Vector bob, gain, answer;  // place [m], the two changes of V [m/s]
  double length;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.54, 30, 0.8);
    const double scale = 0.75 * length / gain.norm();  // [s]
    const Vector along = bob / length, across(-along.y(), along.x()), V = scale * gain, change = scale * answer,
                 after = V + change;
    const double moved = acts.share(4, time);
    const Vector now = bob + moved * after;

    std::vector<Point> seen{{-0.3 * length, 0.1 * length}, {0.3 * length, 0.1 * length}};
    for (const Vector& p : {bob, Vector(bob + V), Vector(bob + 0.5 * length * along), Vector(bob + 2 * after)})
      seen.emplace_back(p);
    canvas.look(fit(bounds(seen), left, 36));
    const double arc = 0.45 + std::asin(std::min(1.0, after.norm() / length));
    std::vector<Point> circle;
    for (int i = -40; i <= 40; ++i) {
      const auto [sin, cos] = sin_cos(arc * i / 40);
      circle.emplace_back(Vector(cos * bob.x() - sin * bob.y(), sin * bob.x() + cos * bob.y()));
    }
    canvas.clip(left);
    canvas.path(circle, {palette::theory, 1.6, Dash::dotted});
    const Stroke guide{palette::muted, 1.5, Dash::dashed};
    canvas.line(bob, bob + 0.5 * length * along, guide);
    canvas.line(bob - 0.62 * length * across, bob + 0.62 * length * across, guide);
    canvas.clip({});
    pictures::draw(canvas, {.bobs = {{now, 1}}, .rods = {{{0, 0}, now}}, .anchors = {{0, 0}}});

    const bool solved = acts.share(3, time) > 0;
    if (moved > 0) canvas.disc(bob, 15 / canvas.camera().scale, {fade(palette::paper, 0), {palette::muted, 1.6}});
    pictures::draw_growing(canvas, bob, V, acts.share(0, time),
                           {palette::velocity, solved ? 2.5 : 4.5, solved ? Dash::dashed : Dash::solid});
    const double seen_rate = acts.share(1, time);
    if (seen_rate > 0) {
      const Vector foot = V.dot(along) * along;
      canvas.line(bob + V, bob + V + seen_rate * (foot - V), {palette::error, 1.6, Dash::dotted});
      pictures::draw_growing(canvas, bob, foot, seen_rate, {palette::error, 4.5});
      if (seen_rate == 1 && row.JV != 0) pictures::draw_right_angle(canvas, bob + foot, V - foot, -foot, 14);
    }
    pictures::draw_growing(canvas, bob + V, change, acts.share(2, time), {palette::force, 4.5});
    pictures::draw_growing(canvas, bob, after, acts.share(3, time), {palette::velocity, 4.5});
    if (acts.share(3, time) == 1 && after.norm() > 0) pictures::draw_right_angle(canvas, bob, after, -along);
    acts.draw(canvas, right, time);
  }
};

}  // namespace

void within_a_step(const Setting& setting, Page& page) {
  const OneRow row = shown_row(setting);
  const Pendulum scene = let_go(setting);
  const Vector bob = scene.bodies().pose[1].position, answer = row.lambda / setting.mass() * row.d;
  const double length = setting.length(), h = setting.h(), rate = row.JV / length, impulse = row.lambda * length;
  const Vector sum = row.v2 + answer;
  const Vector left(course::without_rounding(sum.x(), row.v2.norm()),
                    course::without_rounding(sum.y(), row.v2.norm()));
  const std::string fate = rate > 0 ? "longer" : rate < 0 ? "shorter" : "";
  const pictures::Acts acts(
      {{say("|V| = gh = @ m/s", Value(row.v2.norm(), 3)), "Gravity adds gh to V, straight down.",
        palette::velocity},
       {say("JV/|d| = @ m/s", Value(rate, 3)),
        rate == 0 ? "V has no part along d: JV = 0." : say("The part of V along d: the rod would get @.", fate),
        palette::error},
       {say("λ|d| = −JV|d|/(JM⁻¹J^T) = @ N·s", Value(impulse, 3)),
        rate == 0 ? "There is nothing to remove: λ = 0."
                  : say("λ takes away that part and no more: the rod @.", impulse < 0 ? "pulls" : "pushes"),
        palette::force},
       {say("|V + M⁻¹J^Tλ| = @ m/s", Value(left.norm(), 3)),
        left.norm() > 0 ? say("@ along the tangent, at a right angle to d.",
                              rate == 0 ? "V already lies" : "What is left of V lies")
                        : "Nothing is left of V.",
        palette::velocity},
       {say("|hV| = @ mm", Value(1000 * h * left.norm(), 3)),
        left.norm() > 0 ? say("The bob moves by hV, drawn @ times as far. The tangent leaves the circle.",
                              Value(0.75 * length / (gravity() * h * h), 2))
                        : "The bob stays where it is.",
        palette::ink}});
  page.sequence(
      "within_a_step",
      say(R"(One step of @ s, slowed to @ s. All arrows are velocities at one scale; M⁻¹Jᵀλ is the change of velocity by the impulse.)",
          setting.h, acts.seconds()),
      Seconds{acts.seconds()},
      [film = StepFilm{acts, row, bob, row.v2, answer, length}](Canvas& canvas, double time) {
        film.draw(canvas, time);
      });
}

}  // namespace byhand::single_constraint
