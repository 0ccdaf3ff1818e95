// Step 5: restitution, where it enters, and why a bounce on overlap gains energy.

#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/scenes/balls.hpp"

namespace byhand::contact {
namespace {

constexpr double bounce_seconds = 3, ball_radius = 0.15;  // [s], of the ball [m]
constexpr double bounce_threshold = 0.1;                  // slower contacts rest [m/s]
constexpr int bounces = 3, fine = 16;

using Solved = Simulation<PlaneBody>;

Solved solved(const Setting& setting, double e) {
  Solved simulation{bouncing_ball<PlaneBody>(setting.drop, e, ball_radius), {}};
  // A contact is seen within v h and the margin, but a step falls by gh² more: of a long step the margin has to
  // hold that, or the ball sinks in, and its correction lifts it.
  Scene<PlaneBody>& scene = simulation.scene;
  scene.set_margin(std::max(scene.colliders().margin, gravity * setting.h * setting.h));
  simulation.method.bounce_threshold = bounce_threshold;
  return simulation;
}

double height(const Solved& ball) { return ball.scene.bodies().pose[1].position.y() - ball_radius; }

/// A particle that bounces when it finds itself under the ground: JV⁺ = -e JV⁻, with the V that a step has made.
struct OnOverlap {
  double h, e;
  Pose<PlaneParticle> pose;
  Velocity<PlaneParticle> velocity = Velocity<PlaneParticle>::Zero();
  double time = 0;

  void step() {
    //! [on_overlap]
    velocity.y() -= gravity * h;
    if (pose.position.y() < 0 && velocity.y() < 0) velocity.y() = -e * velocity.y();
    pose.position += h * velocity;
    //! [on_overlap]
    time += h;
  }
};
double height(const OnOverlap& ball) { return ball.pose.position.y(); }

/// A particle that bounces as the solver's contacts do, in its plainest form: a first solve that closes the gap,
/// and a second for the bounce.
struct TwoSolves {
  double h, e;
  Pose<PlaneParticle> pose;
  double velocity = 0, time = 0;

  void step() {
    double& y = pose.position.y();
    //! [two_solves]
    const double gap = y, begins = velocity - gravity * h / 2;  // symplectic Euler's V is half a step old
    velocity -= gravity * h;
    const bool touches = velocity < -gap / h;
    if (touches) velocity = -gap / h;  // first solve: close the gap
    y += h * velocity;
    const double meets = std::sqrt(begins * begins + 2 * gravity * gap);  // the parabola's speed at the ground
    if (touches && meets > bounce_threshold) velocity = e * meets + gravity * h / 2;  // second solve
    //! [two_solves]
    time += h;
  }
};
double height(const TwoSolves& ball) { return ball.pose.position.y(); }
TwoSolves two_solves(const Setting& setting, double e) {
  return {setting.h, e, {Linear<PlaneParticle>(0, setting.drop)}};
}
void step(TwoSolves& ball, double) { ball.step(); }

OnOverlap on_overlap(const Setting& setting, double e) {
  return {setting.h, e, {Linear<PlaneParticle>(0, setting.drop)}};
}

void step(Solved& ball, double h) { ball.step(h); }
void step(OnOverlap& ball, double) { ball.step(); }

/// The highest points after each bounce [m].
template <class AnyBall>
std::vector<double> peaks(AnyBall ball, double h, int count) {
  std::vector<double> peaks;
  double before = height(ball), now = before;
  bool rising = false;
  while (static_cast<int>(peaks.size()) < count && ball.time < 60) {
    step(ball, h);
    before = std::exchange(now, height(ball));
    if (rising && now < before) peaks.push_back(before);
    if (now != before) rising = now > before;  // at the top it may stand for a step
  }
  return peaks;
}

template <class AnyBall>
Curve heights(const std::string& name, AnyBall ball, double h, Colour colour) {
  Curve curve{.label = name, .x = {0}, .y = {height(ball)}, .colour = colour};
  while (ball.time < bounce_seconds - 0.5 * h) {
    step(ball, h);
    curve.x.push_back(ball.time);
    curve.y.push_back(height(ball));
  }
  return curve;
}

struct BounceFilm {
  OnOverlap overlap;
  Solved coarse, finer;
  double h, top;
  Chart chart;

  void draw(Canvas& canvas, double time) {
    while (overlap.time < time - 0.5 * h) {
      overlap.step();
      coarse.step(h);
      for (int i = 0; i < fine; ++i) finer.step(h / fine);
    }
    const auto [left, right] = canvas.page().inset(16).panels(0.42, 20);
    canvas.look(fit({-1.2, -0.2, 2.4, top + 2 * ball_radius + 0.3}, left, 4));
    canvas.ground({-1.2, 0}, {1.2, 0});
    const double all[] = {height(overlap), height(coarse), height(finer)};
    for (int i = 0; i < 3; ++i) {
      const double x = 0.75 * (i - 1);
      canvas.disc({x, all[i] + ball_radius}, ball_radius, {palette::series(i), {palette::ink, 1.8}});
      canvas.text({x, -0.12}, chart.curves[i].label, {.size = 16, .colour = palette::series(i)});
    }
    canvas.look_at_page();
    renderer::draw(canvas, pictures::grown_to(chart, time), right.lowered(60));
  }
};

BounceFilm film(const Setting& setting) {
  const double h = setting.h();
  BounceFilm film{on_overlap(setting, 1), solved(setting, 1), solved(setting, 1), h, 0, {}};
  film.chart = {.x = {.label = "time (s)"}, .y = {.label = "height (m)"}};
  film.chart.curves = {heights("on overlap", film.overlap, h, palette::series(0)),
                       heights("solver, h", film.coarse, h, palette::series(1)),
                       heights(say("solver, h/@", fine), film.finer, h / fine, palette::series(2))};
  film.chart.references.push_back({.value = setting.drop, .label = "dropped from here"});
  for (const Curve& curve : film.chart.curves)
    film.top = std::max(film.top, *std::max_element(curve.y.begin(), curve.y.end()));
  return film;
}

Chart peaks_over_bounces(const Setting& setting) {
  const double e = setting.restitution, h = setting.h();
  constexpr int shown = 6;
  Chart chart{.x = {.label = "bounce"}, .y = {.label = "peak (m)", .scale = Scale::logarithmic}};
  const auto add = [&](std::string name, const std::vector<double>& heights, CurveStyle style) {
    Curve curve{.label = std::move(name), .style = style};
    for (std::size_t i = 0; i < heights.size(); ++i) {
      curve.x.push_back(static_cast<double>(i + 1));
      curve.y.push_back(heights[i]);
    }
    chart.curves.push_back(std::move(curve));
  };
  add("on overlap, h", peaks(on_overlap(setting, e), h, shown), CurveStyle::line_and_markers);
  add("solver, h", peaks(solved(setting, e), h, shown), CurveStyle::markers);
  add(say("solver, h/@", fine), peaks(solved(setting, e), h / fine, shown), CurveStyle::markers);
  Curve law{.label = "e²ⁿ", .style = CurveStyle::theory};
  for (int n = 1; n <= shown; ++n) {
    law.x.push_back(n);
    law.y.push_back(setting.drop * std::pow(e * e, n));
    chart.x.ticks.push_back({static_cast<double>(n), say("@", n)});
  }
  chart.curves.push_back(law);
  chart.y.range = {0.5 * law.y.back(), setting.drop};
  return chart;
}

}  // namespace

void bounce(const Setting& setting, Page& page) {
  const double e = setting.restitution, h = setting.h(), drop = setting.drop;

  page.text(
      R"(Until now a contact stopped a body that approached. Let it return some of the speed: the share e, the
      *restitution*, of the rate of approach JV⁻.)");
  page.formula("JV⁺ = −e JV⁻,   that is (21) with b = e JV⁻", R"(JV^+ = -e\,JV^-, \qquad b = e\,JV^-)");
  page.text(
      R"(It seems to take one line: where the ball is below the ground, reverse its speed. That line in a complete
      step:)");
  page.excerpt("lessons/05_contact/bounce.cpp", "on_overlap");
  const std::vector<double> overlap = peaks(on_overlap(setting, 1), h, bounces),
                            own = peaks(solved(setting, 1), h, bounces);
  page.choose(
      {.ask = say("e = 1, dropped from @ m, reversed like this. Does the ball come back to the same height?",
                  setting.drop),
       .options = {{"higher", "When V is reversed, this step's gh is already in it."},
                   {"to the same height", "|V| does not change, but which V is reversed?"},
                   {"lower", "Being below the ground costs it nothing here."}},
       .answer = overlap.front() > drop   ? 0
                 : overlap.front() < drop ? 2
                                          : 1,
       .hints = {"Compare the last step of the way down with the first of the way up.",
                 "Gravity's gh is added first. In which direction does it act once V is reversed?",
                 "The ball starts up gh faster than it came down in the step before."}});
  page.sequence(
      "three_balls",
      say(R"(e = 1, dropped from @ m. Blue: its speed is reversed where it is below the ground. The others: the
          solver, with steps of h and of h/@.)",
          setting.drop, fine),
      Seconds{bounce_seconds},
      [film = film(setting)](Canvas& canvas, double time) mutable { film.draw(canvas, time); });
  page.text(
      R"(With e = 1 it should come back to @ m. Reversed on overlap its peaks are @ m: it *gains* energy, because V
      already holds this step's gravity when it is reversed, and the gh that pulled down now pushes up. The ball starts
      up gh faster than it came down and climbs for one step longer; each peak is higher by about h·v, the height of the
      last step's fall.)",
      setting.drop, overlap);
  page.text(
      R"(The solver solves twice. In the first solve the row closes the gap, as always (b = C/h), and the positions
      move: the ball arrives *on* the ground. Then the rows are solved again with b = e JV⁻. Which speed is JV⁻? Not the
      speed before the step, which lacks the last part of the fall, nor the speed after it, which has too much. The
      heights of a falling ball lie on a parabola that meets the ground within the step; JV⁻ is its speed there. For the
      ball to start up at e times that speed, V needs another ½gh. For one ball:)");
  page.excerpt("lessons/05_contact/bounce.cpp", "two_solves");
  page.text(
      R"(The threshold keeps a resting ball from rattling. The solver does the same for all contacts together; its second
      solve continues from the λ of the first, so that the sum is clamped:)");
  page.excerpt("solver/contact/restitution.hpp", "parting");
  page.text(
      R"(The solver's highest peak with e = 1 is at @ m. The steps of a fall from rest lie on a parabola whose top is
      gh²/8 = @ m above the start, so the ball should return to @ m, and a step may miss that top by as much again. It lags, too: it waits on
      the ground until the step ends. With
      e = @ each bounce keeps the share e of the speed, and so e² of the height:)",
      Value(*std::max_element(own.begin(), own.end()), 6), Value(gravity * h * h / 8, 2),
      Value(drop + gravity * h * h / 8, 6), setting.restitution);
  page.figure("peaks",
              say(R"(Peaks after each bounce, e = @, from @ m. Dashed: e²ⁿ of that. The solver's ball rests once it
            meets the ground at @ m/s or less; a flight within a step has no peak.)",
                  setting.restitution, setting.drop, bounce_threshold),
              peaks_over_bounces(setting));

  page.measure("first peak, e = 1, on overlap", overlap.front(), "m");
  page.measure("first peak, e = 1, solver", own.front(), "m");
  // After n steps it is h²g n(n + 1)/2 lower; the step after that turns g h (n + 1) round.
  const double n = std::ceil((std::sqrt(1 + 8 * drop / (gravity * h * h)) - 1) / 2);
  page.claim("first peak on overlap, e = 1", overlap.front(), "m",
             is(drop + gravity * h * h * (n + 1), "hv above the start, step by step", absolute(1e-9 * drop)));
  page.claim(
      "highest peak of the solver, e = 1", *std::max_element(own.begin(), own.end()), "m",
      is_at_most(drop + gravity * h * h / 8, "nothing is gained: the top of the parabola of a fall from rest"));
  const std::vector<double> plain = peaks(two_solves(setting, e), h, bounces),
                            all = peaks(solved(setting, e), h, bounces);
  double differ = std::abs(static_cast<double>(plain.size()) - static_cast<double>(all.size()));
  for (std::size_t i = 0; i < std::min(plain.size(), all.size()); ++i)
    differ = std::max(differ, std::abs(plain[i] - all[i]));
  page.claim("peaks of the plain two solves beside the solver's, largest difference", differ, "m",
             is(0, "the same method", absolute(1e-9 * drop)),
             Condition{std::pow(e, bounces) * std::sqrt(2 * gravity * drop) > gravity * h,
                       "a ball that is off the ground for two steps after each bounce"});
  const double step = h / 256;
  const std::vector<double> exact = peaks(solved(setting, e), step, bounces);
  for (int k = 0; k < bounces; ++k)
    page.claim(say("peak @ of the solver, h/256", k + 1), k < static_cast<int>(exact.size()) ? exact[k] : NAN, "m",
               is(drop * std::pow(e * e, k + 1), "e²ⁿ of the drop, to gh²/8",
                  absolute(gravity * step * step / 8 + 1e-9 * drop)));
}

}  // namespace byhand::contact
