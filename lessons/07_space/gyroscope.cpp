// Deeper: a top on its tip, whose axis is level.

#include "lessons/07_space/gyroscope.hpp"

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "lessons/scenes/top.hpp"

namespace byhand::space {

HeavyTop gyroscope_of(double mass) {
  const double along = mass * wheel * wheel;
  return {.mass = mass,
          .arm = arm,
          .moment_along = along,
          .moment_across = along / 2 + mass * arm * arm,
          .spin = wheel_rate,
          .gravity = gravity};
}

namespace {

constexpr double precession_seconds = 4;

/// Where the axle points over time.
struct Run {
  std::vector<double> time, azimuth;  // [s], [rad]
  std::vector<Point3> place;          // of the wheel [m]
};
Run let_go(const Setting& setting, Gyroscopic choice, double precession) {
  Simulation<SpaceBody> top{spinning_top(gyroscope_of(setting.mass), level, precession),
                            {Direct{}, Baumgarte{0.2}}};
  top.method.gyroscopic = choice;
  const double h = setting.h / 64;
  Run run;
  double azimuth = 0;
  Point3 x = top.scene.bodies().pose[1].position;
  for (int i = 0; top.time < precession_seconds; ++i) {
    if (i % 64 == 0) {
      run.time.push_back(top.time);
      run.azimuth.push_back(azimuth);
      run.place.push_back(x);
    }
    top.step(h);
    const Point3 next = top.scene.bodies().pose[1].position;
    azimuth += std::atan2(x.z() * next.x() - x.x() * next.z(), x.x() * next.x() + x.z() * next.z());
    x = next;
  }
  return run;
}

double mean_rate(const Run& run) { return run.azimuth.back() / run.time.back(); }

void draw_wheel(Space& space, const Point3& place, double shade) {
  const auto pale = [&](Colour colour) { return mix(palette::paper, colour, shade); };
  const Point3 axis = place.normalized();
  pictures::add_ring(space, place, axis, wheel, 0.028, pale(palette::muted));
  const Point3 out = axis.unitOrthogonal();
  for (const Point3& spoke : {out, Point3(axis.cross(out))})
    space.rod(place - wheel * spoke, place + wheel * spoke, 0.007, pale(palette::body));
  space.rod({0, 0, 0}, 1.15 * place, 0.012, pale(palette::fixed));
}

void draw_run(Canvas& canvas, const Run& run, const Chart& chart) {
  const auto [left, right] = canvas.page().inset(20).panels(0.5, 16);
  Space space(pictures::from_aside({0, -0.12, 0}, 0.68, left, 0.5, 0.4));
  space.ground({0, -0.6, 0}, 1.4, 0.2);
  space.rod({0, -0.6, 0}, {0, -0.02, 0}, 0.02, palette::fixed);
  const std::size_t last = run.place.size() - 1;
  for (const std::size_t i : {std::size_t{0}, last / 2, last})
    draw_wheel(space, run.place[i], 0.25 + 0.75 * static_cast<double>(i) / static_cast<double>(last));
  const Point3 axis = run.place[last].normalized();
  space.arrow(1.15 * run.place[last], run.place[last] + 0.32 * axis, 0.012, palette::error);
  space.arrow(run.place[last], run.place[last] - Point3(0, 0.42, 0), 0.012, palette::force);
  canvas.draw(space);
  canvas.text(space.project(run.place[last] + 0.32 * axis), "Iω",
              {.size = 20, .colour = palette::error, .halo = 3, .offset = {0, 20}});
  canvas.text(space.project(run.place[last] - Point3(0, 0.42, 0)), "mg",
              {.size = 20, .colour = palette::force, .halo = 3, .offset = {0, -16}});
  renderer::draw(canvas, chart, right.lowered(70));
}

}  // namespace

void gyroscope(const Setting& setting, Page& page) {
  const HeavyTop top = gyroscope_of(setting.mass);
  // Left out, each ω counts alike, as if the wheel were a ball with its moment across.
  HeavyTop ball = top;
  ball.moment_along = top.moment_across - top.mass * arm * arm;
  const double exact = top.precession(level)[0], as_ball = ball.precession(level)[0];
  const Run run = let_go(setting, Gyroscopic::implicit, exact),
            without = let_go(setting, Gyroscopic::none, as_ball);

  page.text(
      R"(Now gravity acts on a spinning body: a wheel, a thin ring of @ kg and radius R = @ m, spinning at @ rad/s on an
      axle. The other end of the axle is held on a post by a ball joint of three rows, @ m from the wheel. The axle
      starts at the steady rate at which it goes round the post; released from rest it would also nutate: nod up and
      down.)",
      setting.mass, wheel, wheel_rate, arm);
  HeavyTop twice = top;
  twice.spin *= 2;
  const double change = twice.precession(level)[0] / exact;
  page.choose(
      {.ask =
           "The weight pulls the wheel down, but the axle goes round. If the wheel spins twice as fast, what does "
           "the axle do?",
       .options = {{"it goes round half as fast", "The same torque has twice the Iω to turn."},
                   {"it goes round as before",
                    "The torque is the same, but the Iω that it turns is twice as large."},
                   {"it goes round twice as fast",
                    "The axle does not share the spin; the weight's torque has to turn it."},
                   {"it falls", "The torque is level, so Iω, along the axle, turns within the level plane."}},
       .answer = change < 0.75  ? 0
                 : change < 1.5 ? 1
                                : 2,
       .hints = {"In which direction does the torque of the weight change Iω?",
                 "|d(Iω)/dt| = mga, level and at right angles to the axle; Iω turns at the rate φ̇.",
                 "mR²ω · φ̇ = mga"}});
  page.text(
      R"(The wheel's Iω is mR²ω = @ kg m²/s along the axle, and the weight's torque is mga = @ N m. It points sideways, so
      Iω goes round:)",
      top.moment_along * wheel_rate, top.mass * gravity * arm);
  page.formula(
      "|d(Iω)/dt| = |Iω| φ̇ = mga   ⟹   φ̇ = ga/(R²ω) = @ rad/s",
      R"(\Bigl|\frac{d(I\omega)}{dt}\Bigr| = |I\omega|\,\dot\varphi = mga \quad\Rightarrow\quad \dot\varphi
         = \frac{ga}{R^2\omega} = @\ \mathrm{rad/s})",
      exact);
  Chart chart{.x = {.label = "time (s)"}, .y = {.label = "turned about the vertical (deg)"}};
  // Colours as in step 6.
  const auto curve = [&](const char* name, const char* law, const Run& of, double by, Colour colour) {
    Curve measured{.label = name, .style = CurveStyle::markers, .colour = colour},
        theory{.label = law, .style = CurveStyle::theory};
    const auto every = static_cast<std::size_t>(std::max(1L, std::lround(0.25 / setting.h)));
    for (std::size_t i = 0; i < of.time.size(); i += every) {
      measured.x.push_back(of.time[i]);
      measured.y.push_back(degrees(of.azimuth[i]));
    }
    theory.x = {0, precession_seconds};
    theory.y = {0, degrees(by * precession_seconds)};
    chart.curves.push_back(std::move(measured));
    chart.curves.push_back(std::move(theory));
  };
  curve("implicit", "exact, wheel", run, exact, palette::series(2));
  curve("left out", "exact, ball", without, as_ball, palette::series(0));
  page.figure(
      "gyroscope",
      say(R"(The gyroscope over @ s, from pale to dark: it does not fall, it goes round. Right: its angle, with the
                  gyroscopic term and without. Dashed: the exact rates of the wheel and of a ball.)",
          precession_seconds),
      [=](Canvas& canvas) { draw_run(canvas, run, chart); });
  const double faster = mean_rate(without) / mean_rate(run);
  page.text(
      R"(Without the gyroscopic term it also goes round, and looks right, but at @ the rate: the solver then
      treats the wheel as a ball, with ½mR², its moment across the axle, about every axis. No picture tells you that; a
      number does.)",
      std::abs(faster - 2) < 0.005 ? "twice" : say("@ times", Value(faster, 3)));

  const double turned = wheel_rate * setting.h / 64;
  page.claim("precession at h/64", mean_rate(run), "rad/s", is(exact, "steady heavy top", relative(turned)));
  page.claim("the same, gyroscopic term left out", mean_rate(without), "rad/s",
             is(as_ball, "a ball with the moment across", relative(turned)));
}

}  // namespace byhand::space
