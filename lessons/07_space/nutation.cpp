// Step 4: the spherical pendulum, that swings between two cones while it goes round.

#include <cmath>

#include "lessons/07_space/rounds.hpp"
#include "lessons/07_space/steps.hpp"
#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/exact/spherical_pendulum.hpp"
#include "lessons/pictures/growing.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "solver/measure.hpp"

namespace byhand::space {
namespace {

using namespace tutor;
using namespace renderer;

constexpr double nod_seconds = 4;

SphericalPendulum exact_for(const Setting& setting) {
  const double angle = radians(setting.angle);
  return {angle, setting.share * ConicalPendulum(angle, setting.length, gravity).angular_velocity(),
          setting.length, gravity};
}

/// What the film shows: where the bob was after each step.
struct NutationFilm {
  double length, angle, other;  // [m], [rad]
  std::vector<double> time = {};
  std::vector<Point3> place = {};
  Chart beside = {};

  void draw(Canvas& canvas, double now) const {
    const auto [left, right] = canvas.page().inset(20).split_columns(0.58, 16);
    Space space(pictures::from_aside({0, -0.55 * length, 0}, 1.12 * length, left, 0.5, 0.3));
    space.ground({0, -1.3 * length, 0}, 2.4 * length, 0.4 * length);
    for (const double cone : {angle, other})
      pictures::add_ring(space, {0, -length * std::cos(cone), 0}, Point3::UnitY(), length * std::sin(cone),
                         0.01 * length, palette::fixed);
    std::vector<Point3> trail;
    const double step = time[1];
    const auto every = static_cast<std::size_t>(std::max(1L, std::lround(1 / (30 * step))));
    std::size_t last = 0;
    while (last + 1 < time.size() && time[last + 1] <= now + 1e-9) ++last;
    for (std::size_t i = last % every; i <= last; i += every) trail.push_back(place[i]);
    pictures::add_trail(space, trail, 0.022 * length, palette::velocity);
    space.rod({0, 0, 0}, place[last], 0.014 * length, palette::constraint);
    space.sphere({0, 0, 0}, 0.035 * length, palette::fixed);
    space.sphere(place[last], 0.08 * length, palette::body);
    canvas.draw(space);
    canvas.text({left.x + 4, left.top() - 14}, say("@ s", Value(std::floor(now * 10 + 1e-6) / 10, 3)),
                {.size = 22, .anchor = renderer::Anchor::left, .bold = true});
    renderer::draw(canvas, pictures::grown_to(beside, now), right.inset(0, 70));
  }
};

NutationFilm film_of(const Setting& setting, const SphericalPendulum& exact) {
  NutationFilm film{.length = setting.length, .angle = radians(setting.angle), .other = exact.other_angle()};
  Curve run{.label = "run"}, theory{.label = "exact", .style = CurveStyle::theory};
  Bob bob = set_out(setting);
  for (const double h = setting.h; bob.time <= nod_seconds + 1e-9; bob.step(h)) {
    film.time.push_back(bob.time);
    film.place.push_back(bob.scene.bodies().pose[1].position);
    run.x.push_back(bob.time);
    run.y.push_back(degrees(from_down(bob)));
  }
  for (int i = 0; i <= 60; ++i) {
    theory.x.push_back(i * nod_seconds / 60);
    theory.y.push_back(degrees(exact.at(theory.x.back()).angle));
  }
  film.beside = {
      .x = {.label = "time (s)"}, .y = {.label = "angle from straight down (deg)"}, .curves = {run, theory}};
  return film;
}

struct Errors {
  double period, precession;  // relative
};
Errors errors(const Setting& setting, const Nutation& exact, double h) {
  const Nutation run = nutation_of(set_out(setting), h);
  return {run.period / exact.period - 1, run.precession / exact.precession - 1};
}

Chart over_h(const Setting& setting, const Nutation& exact) {
  Chart chart{.x = {.label = "time step h (s)", .scale = Scale::logarithmic},
              .y = {.label = "relative error (1)", .scale = Scale::logarithmic}};
  Curve period{.label = "nutation", .style = CurveStyle::line_and_markers},
      precession{.label = "precession", .style = CurveStyle::line_and_markers},
      slope{.label = "∝ h²", .style = CurveStyle::theory};
  for (double h = setting.h; h > setting.h / 100; h /= 2) {
    const Errors error = errors(setting, exact, h);
    period.x.push_back(h);
    period.y.push_back(std::abs(error.period));
    precession.x.push_back(h);
    precession.y.push_back(std::abs(error.precession));
  }
  slope.x = {period.x.front(), period.x.back()};
  for (const double h : slope.x) slope.y.push_back(2 * period.y.back() * std::pow(h / period.x.back(), 2));
  chart.curves = {period, precession, slope};
  return chart;
}

}  // namespace

void nutation(const Setting& setting, Page& page) {
  const double h = setting.h, mass = setting.mass;
  const SphericalPendulum pendulum = exact_for(setting);
  const Nutation exact{pendulum.nutation_period(), pendulum.at(pendulum.nutation_period()).azimuth};
  const Nutation run = nutation_of(set_out(setting), h);

  page.text(
      R"(Give it @ of that speed, and it falls inward, is thrown out again, and swings between two cones:
      *nutation*. Meanwhile it goes round: *precession*. Both are known exactly. With u = cosθ,)",
      setting.share);
  page.formula("u̇² = 2(E/m + gLu)(1 − u²)/L² − (L_y/(mL²))²",
               R"(\dot u^2 = \frac{2}{L^2}\Bigl(\frac{E}{m} + gLu\Bigr)(1-u^2) - \Bigl(\frac{L_y}{mL^2}\Bigr)^2)");
  page.text(
      R"(a cubic in u: its two roots are the cones, at @° and @°, and the time between them is an elliptic
      integral. One nutation takes @ s and leads @° round the vertical.)",
      setting.angle, degrees(pendulum.other_angle()), exact.period, degrees(exact.precession));
  page.sequence("between_two_cones",
                say(R"(The bob set out sideways at @ of the cone's speed. Grey rings: the two cones between which
                    it must stay. Right: its angle, and dashed the elliptic one.)",
                    setting.share),
                Seconds{nod_seconds},
                [film = film_of(setting, pendulum)](Canvas& canvas, double time) { film.draw(canvas, time); });

  Bob bob = set_out(setting);
  while (bob.time < nod_seconds) bob.step(h);
  const double kept = angular_momentum(bob.scene.bodies())[1], given = pendulum.angular_momentum(mass);
  page.choose(
      {.ask = "The run errs in its angle and in its energy. And in its angular momentum about the vertical?",
       .options = {{"not at all, to rounding",
                    R"(Yes. λ acts along d, through the anchor; gravity acts along the vertical; and the position
                    moves along v. None of the three has an arm about the vertical, at any h.)"},
                   {"by as much as the angle",
                    "What could change it in a step? λ acts along d, through the anchor."},
                   {"a little, for J is held still over the step",
                    "J is d at the start of the step, and so is the arm of λ: d × d is zero at any h."}},
       .answer = std::abs(kept / given - 1) < 1e-9 ? 0 : 1,
       .hints = {"Take L = x × mv before and after: v changes by gh and by a multiple of d = x, then x by hv."}});
  page.figure("errors_over_h",
              R"(Error of one nutation's duration, and of how far round it leads, over the time step. Both fall
              with h²: half the step, a quarter of the error.)",
              over_h(setting, exact));
  page.text(
      R"(That may surprise you: the drift of lesson 4 fell with h alone. But symplectic Euler's velocities are
      those of the leapfrog, which is of second order, half a step late; and this bob sets out at a turning point,
      where half a step makes no difference to first order. Let it set out anywhere else, and the error falls with
      h alone.)");
  page.measure("one nutation", run.period, "s");
  page.measure("precession in it", degrees(run.precession), "deg");

  const double turned = 2 * pi / exact.period * h;
  page.claim({.quantity = "nutation",
              .unit = "s",
              .expected = exact.period,
              .source = "elliptic integral",
              .measured = run.period,
              .tolerance = relative(turned * turned),
              .claimed = turned <= 0.2,
              .range = "2πh/nutation ≤ 0.2"});
  page.claim({.quantity = "precession in it",
              .unit = "rad",
              .expected = exact.precession,
              .source = "certified integration",
              .measured = run.precession,
              .tolerance = relative(turned * turned),
              .claimed = turned <= 0.2,
              .range = "2πh/nutation ≤ 0.2"});
  page.claim({.quantity = "order: halvings of the nutation's error, from h/16 to h/32",
              .unit = "1",
              .expected = 2,
              .source = "h²",
              .measured = std::log2(errors(setting, exact, h / 16).period / errors(setting, exact, h / 32).period),
              .tolerance = absolute(0.1)});
  page.claim({.quantity = say("L about the vertical after @ s", nod_seconds),
              .unit = "kg m²/s",
              .expected = given,
              .source = "mL²sin²θ·φ̇ at the start",
              .measured = kept,
              .tolerance = relative(1e-11)});
}

}  // namespace byhand::space
