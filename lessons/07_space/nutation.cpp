// Step 4: the spherical pendulum, that swings between two cones while it goes round.

#include "lessons/07_space/rounds.hpp"
#include "lessons/07_space/steps.hpp"
#include "lessons/exact/conical_pendulum.hpp"
#include "lessons/exact/spherical_pendulum.hpp"
#include "lessons/pictures/space_scene.hpp"

namespace byhand::space {
namespace {

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
    const auto [left, right] = canvas.page().inset(20).panels(0.58, 16);
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
    renderer::draw(canvas, pictures::grown_to(beside, now), right.lowered(70));
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
  for (const double angle : exact.angles(nod_seconds, 60)) {
    theory.x.push_back(static_cast<double>(theory.x.size()) * nod_seconds / 60);
    theory.y.push_back(degrees(angle));
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
              .y = {.label = "relative error", .scale = Scale::logarithmic}};
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
      R"(Give the bob half that speed, and it falls inward and moves out again, so it swings between two cones:
      *nutation*.
      Meanwhile it goes round the vertical: *precession*. Both are known exactly. With u = cosθ,)");
  page.formula("u̇² = 2(E/m + gLu)(1 − u²)/L² − (L_y/(mL²))²",
               R"(\dot u^2 = \frac{2}{L^2}\Bigl(\frac{E}{m} + gLu\Bigr)(1-u^2) - \Bigl(\frac{L_y}{mL^2}\Bigr)^2)");
  page.text(
      R"(is a cubic in u. Two of its roots lie between −1 and 1: the two cones, at @° and @°. The time from one to the other
      and back, 2∫du/|u̇|, is an elliptic integral. One nutation takes @ s, in which the bob goes @° round the vertical.)",
      setting.angle, degrees(pendulum.other_angle()), exact.period, degrees(exact.precession));
  page.derivation(
      "Why u̇² is a cubic in u",
      {{"energy and angular momentum about the vertical stay",
        "E = ½mL²(θ̇² + sin²θ φ̇²) − mgL cosθ,   L_y = mL² sin²θ φ̇",
        R"(E = \tfrac12 mL^2(\dot\theta^2 + \sin^2\theta\,\dot\varphi^2) - mgL\cos\theta, \quad L_y = mL^2\sin^2\theta\,\dot\varphi)"},
       {"solve for θ̇²", "θ̇² = 2(E/m + gL cosθ)/L² − (L_y/(mL² sinθ))²",
        R"(\dot\theta^2 = \frac{2}{L^2}\Bigl(\frac Em + gL\cos\theta\Bigr) - \Bigl(\frac{L_y}{mL^2\sin\theta}\Bigr)^2)"},
       {"u̇ = −sinθ θ̇, sin²θ = 1 − u²", "u̇² = (1 − u²) θ̇²", R"(\dot u^2 = (1 - u^2)\,\dot\theta^2)"}});
  page.sequence(
      "between_two_cones",
      R"(The bob set off sideways at half the cone's speed. Grey rings: the two cones of the exact motion. Right: its
      angle, and dashed the exact one.)",
      Seconds{nod_seconds},
      [film = film_of(setting, pendulum)](Canvas& canvas, double time) { film.draw(canvas, time); });

  Bob bob = set_out(setting);
  while (bob.time < nod_seconds) bob.step(h);
  const double kept = angular_momentum(bob.scene.bodies())[1], given = pendulum.angular_momentum(mass);
  page.choose(
      {.ask =
           "The run has an error in its angle. How large is the error of its angular momentum about the vertical?",
       .options =
           {{"rounding only",
             R"(λ acts along d, which passes through the anchor; gravity acts along the vertical; and the position
                    moves along v. None of the three has a torque about the vertical, at any h.)"},
            {"about as large as the angle's error",
             "What could change it in a step? λ acts along d, which passes through the anchor."},
            {"small, because J is held over the step",
             "J is d at the start of the step, and so is the arm of λ: d × d is zero at any h."}},
       .answer = std::abs(kept / given - 1) < 1e-9 ? 0 : 1,
       .hints = {"Which of λ, gravity and the move has a torque about the vertical?",
                 "L = x × mv: v changes by hg and by a multiple of d = x, then x changes by hv.",
                 "x × x = 0, (x + hv) × v = x × v"}});
  const Errors coarse = errors(setting, exact, h / 32), fine = errors(setting, exact, h / 64);
  const double order = std::log2(coarse.period / fine.period), halved = coarse.precession / fine.precession;
  const std::string slopes = halved > 0
                                 ? say("slopes are @ and @", Value(order, 3), Value(std::log2(halved), 3))
                                 : say("slope of the first is @ and the second changes its sign", Value(order, 3));
  page.figure("errors_over_h",
              say(R"(Errors of the duration of one nutation and of the angle of its precession, over the time step.
                  Over the two shortest steps the @.)",
                  slopes),
              over_h(setting, exact));
  page.text(
      R"(The uncorrected drift of lesson 4 only fell with h. Here the error falls with h², for three reasons. β holds
      the rod's stretch to (ωh)²/2β of its length (lesson 4). Symplectic Euler is the leapfrog, a second-order method,
      with each velocity half a step early. And at a turning point, where this run starts, half a step of acceleration
      is at right angles to v: it changes energy and L_y only to second order.)");
  page.measure("one nutation", run.period, "s");
  page.measure("precession in it", degrees(run.precession), "deg");

  // Of a turn of `turned` [rad] in the longest step: nutation is twice as fast, and the leapfrog errs by the
  // square of that; and β leaves the rod longer by turned²/2β.
  const double lowest = std::min(radians(setting.angle), pendulum.other_angle()),
               fastest = std::sqrt(2 * (pendulum.energy(1) + gravity * setting.length * std::cos(lowest))),
               turned = fastest * h / setting.length;
  const Tolerance second_order = relative(turned * turned * (4 + 1 / (2 * 0.2)));
  page.claim("nutation", run.period, "s", is(exact.period, "elliptic integral", second_order),
             Quantity("turn in the longest step", turned, "rad") <= 0.2);
  page.claim("precession in it", run.precession, "rad",
             is(exact.precession, "certified integration", second_order),
             Quantity("turn in the longest step", turned, "rad") <= 0.2);
  page.claim("order: halvings of the nutation's error, from h/32 to h/64", order, "1", is(2, "h²", absolute(0.1)));
  page.claim(say("L about the vertical after @ s", nod_seconds), kept, "kg m²/s",
             is(given, "mL²sin²θ·φ̇ at the start", relative(1e-11)));
}

}  // namespace byhand::space
