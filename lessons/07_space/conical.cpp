// Step 3: a bob that circles, and what its rod carries.

#include "lessons/07_space/rounds.hpp"
#include "lessons/07_space/steps.hpp"
#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/pictures/space_scene.hpp"

namespace byhand::space {
namespace {

Chart over_angle(const Setting& setting) {
  const double weight = setting.mass * gravity;
  Chart chart{.x = {.label = "angle (deg)", .range = {{0, 80}}},
              .y = {.label = "tension (weights)", .range = {{0, 5}}}};
  Curve run{.label = "λ/h", .style = CurveStyle::markers}, theory{.label = "1/cosθ", .style = CurveStyle::theory},
      along{.label = "cosθ", .style = CurveStyle::theory, .colour = palette::muted};
  for (double angle = 10; angle <= 76; angle += 6) {
    run.x.push_back(angle);
    run.y.push_back(third_turn(circling(setting, radians(angle)), setting.h).tension / weight);
  }
  for (double angle = 0; angle <= 77; angle += 1) {
    theory.x.push_back(angle);
    theory.y.push_back(1 / std::cos(radians(angle)));
    along.x.push_back(angle);
    along.y.push_back(std::cos(radians(angle)));
  }
  chart.curves = {run, theory, along};

  return chart;
}

void draw_cone(Canvas& canvas, double angle, double tension) {
  const Rectangle frame = canvas.page(1.1).inset(10);
  Space space(pictures::from_aside({0.1, -0.66, 0}, 1.0, frame, -0.7, 0.3));
  const Point3 bob(std::sin(angle), -std::cos(angle), 0);
  space.ground({0, -1.35, 0}, 2.4, 0.4);
  pictures::add_ring(space, {0, bob.y(), 0}, Point3::UnitY(), bob.x(), 0.012, palette::muted);
  constexpr double arc_radius = 0.3;
  space.rod({0, 0, 0}, {0, std::min(bob.y(), -1.15 * arc_radius), 0}, 0.005, palette::muted);
  space.rod({0, 0, 0}, bob, 0.014, palette::constraint);
  space.sphere({0, 0, 0}, 0.035, palette::fixed);
  space.sphere(bob, 0.085, palette::body);
  const double scale = std::min(0.32, 0.75 / tension);
  const Point3 pull = bob - scale * tension * bob, weight = bob - Point3(0, scale, 0);
  space.arrow(bob - 0.09 * bob, pull - 0.09 * bob, 0.016, palette::force);
  space.arrow(bob - Point3(0, 0.085, 0), weight - Point3(0, 0.085, 0), 0.016, palette::force);
  space.arrow(bob + Point3(0, 0, 0.085), bob + Point3(0, 0, 0.5), 0.016, palette::velocity);
  canvas.draw(space);
  const TextStyle style{
      .size = 20, .colour = palette::force, .anchor = renderer::Anchor::left, .halo = 3, .offset = {12, 20}};
  canvas.text(space.project(0.5 * (bob + pull) - 0.09 * bob), say("@ weights", Value(tension, 3)), style);
  canvas.text(
      space.project(0.5 * (bob + weight) - Point3(0, 0.085, 0)), "1 weight",
      {.size = 20, .colour = palette::force, .anchor = renderer::Anchor::right, .halo = 3, .offset = {-12, 0}});
  std::vector<Point> arc;
  for (int i = 0; i <= 24; ++i)
    arc.push_back(space.project(arc_radius * Point3(std::sin(i * angle / 24), -std::cos(i * angle / 24), 0)));
  canvas.path(arc, {palette::ink, 2});
  // Within the arc, or outside it if the angle is too narrow there.
  const double wide = 0.1 / std::sin(angle / 2), out = wide < 0.22 ? 0.18 : std::max(1.35 * arc_radius, wide);
  canvas.text(space.project(out * Point3(std::sin(angle / 2), -std::cos(angle / 2), 0)), "θ",
              {.size = 22, .halo = 3});
}

}  // namespace

void conical(const Setting& setting, Page& page) {
  const double angle = radians(setting.angle), weight = setting.mass * gravity, h = setting.h;
  const ConicalPendulum exact(angle, setting.length, gravity);
  const Turn turn = third_turn(circling(setting, angle), h), fine = third_turn(circling(setting, angle), h / 16);
  const double measured = turn.tension / weight;
  const std::string law = say("@", Value(1 / std::cos(angle), 4)), found = say("@", Value(measured, 4));
  const double stretch = turn.distance / setting.length - 1;

  page.text(
      R"(A bob (@ kg) needs no orientation: it is a `SpaceParticle`, and its rod (@ m) is the one row of lesson 2, now
      with six numbers. Started sideways at the right speed it circles at a steady angle: a conical pendulum.)",
      setting.mass, setting.length);
  page.predict(
      {.ask =
           say("It circles on a cone at @° from straight down. How hard does the rod pull, in weights of the bob?",
               setting.angle),
       .answer = exact.tension(setting.mass) / weight,
       .unit = "1",
       .tolerance = 0.03 * exact.tension(setting.mass) / weight,
       .wrong = {{std::cos(angle),
                  "That is the part of the weight along the rod. But it is the *vertical* forces that balance: "
                  "T·cosθ = mg."},
                 {1, "The rod is inclined: only the part T·cosθ of its pull points up."},
                 {std::tan(angle), "That is T·sinθ over mg, the part that keeps the bob on its circle."}},
       .hints = {"The bob stays at its height. Which part of the pull carries the weight?", "T·cosθ = mg",
                 say("T/mg = 1/cos @°", setting.angle)},
       .hinted = 1 / std::cos(angle),
       .right = say("1/cosθ = @; with steps of @ s the run gives @@.", law, setting.h, found,
                    found != law && stretch > 0
                        ? say(": its rod is @ % too long (lesson 4), so the bob nods between @° and @°",
                              Value(100 * stretch, 2), Value(degrees(turn.least), 4), Value(degrees(turn.most), 4))
                        : "")});
  page.figure(
      "tension_over_angle",
      R"(The rod's pull, λ/h, over the angle of the cone, mean of the third turn; below the curve where steps leave
      the rod too long. Lower dashed line: the weight's part along the rod, which is not the pull.)",
      over_angle(setting));
  page.formula("T·cosθ = mg,   T·sinθ = mω²L·sinθ   ⟹   T = mg/cosθ = @ N,   ω² = g/(L·cosθ)",
               R"(T\cos\theta = mg, \quad T\sin\theta = m\omega^2 L\sin\theta \quad\Rightarrow\quad )"
               R"(T = \frac{mg}{\cos\theta} = @\ \mathrm{N}, \quad \omega^2 = \frac{g}{L\cos\theta})",
               exact.tension(setting.mass));
  page.figure(
      "cone",
      say(R"(θ = @°. The forces on the bob in this run (orange) and its velocity (green). The rod's pull carries the
            weight and keeps the bob on its circle.)",
          setting.angle),
      [=](Canvas& canvas) { draw_cone(canvas, angle, measured); });
  page.measure("tension over weight", measured, "1");
  page.measure("one turn", turn.period, "s");

  // A step leaves the circle by ½(vh)² and β pulls that back; to first order in h both periods and pulls are off.
  const double turned = exact.angular_velocity() * h / 16;
  page.claim("tension at h/16", fine.tension, "N", is(exact.tension(setting.mass), "mg/cosθ", relative(turned)));
  page.claim("one turn at h/16", fine.period, "s", is(exact.period(), "2π√(L·cosθ/g)", relative(turned)));
}

}  // namespace byhand::space
