// Step 3: three bodies and four pins that are one pendulum.

#include "lessons/06_joints/dense.hpp"
#include "lessons/06_joints/linkage.hpp"
#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/exact/simple_pendulum.hpp"
#include "renderer/labels.hpp"

namespace byhand::joints {
namespace {

constexpr double four_bar_seconds = 2.5, measured_for = 10;  // [s]

/// What a run of ten seconds says.
struct Swing {
  Curve angle{.label = "arms"};  // [°] over [s], of the film's time
  double period = 0;             // [s], over all swings
  double off = 0, off_at_t = 0;  // largest distance from the pendulum's angle, half a step on and at t [rad]
  double tilt = 0;               // of the coupler, largest [rad]
};

Swing swing_of(const FourBarOptions& bars, const SimplePendulum& pendulum, double h) {
  FourBar linkage{four_bar(bars), exactly()};
  Swing swing;
  std::vector<double> crossings;
  double last = bars.angle;
  advance_to(linkage, measured_for, h, [&] {
    const double now = arm_angle(linkage);
    const auto& coupler = linkage.scene.bodies().pose[3].rotation;
    swing.off = std::max(swing.off, std::abs(now - pendulum.angle(linkage.time + h / 2)));
    swing.off_at_t = std::max(swing.off_at_t, std::abs(now - pendulum.angle(linkage.time)));
    swing.tilt = std::max(swing.tilt, std::abs(std::atan2(coupler.sin, coupler.cos)));
    if (last * now < 0) crossings.push_back(linkage.time - h * now / (now - last));
    last = now;
    if (linkage.time > four_bar_seconds + h) return;
    swing.angle.x.push_back(linkage.time);
    swing.angle.y.push_back(degrees(now));
  });
  if (crossings.size() > 1)
    swing.period = 2 * (crossings.back() - crossings.front()) / (static_cast<double>(crossings.size()) - 1);
  return swing;
}

struct FourBarFilm {
  FourBar linkage;
  FourBarOptions bars;
  SimplePendulum pendulum;
  double h;
  Chart beside;

  void draw(Canvas& canvas, double time) {
    advance_to(linkage, time, h);
    const auto [upper, lower] = canvas.page().inset(16).split_rows(0.6, 10);
    const auto [left, right] = upper.split_columns(0.66, 10);
    const double a = bars.arm, c = bars.coupler, length = pendulum_length(bars);
    canvas.look(fit({-a, -1.1 * a, c + 2 * a, 1.35 * a}, left, 8));
    pictures::draw(canvas, pictures::rods_and_bobs(linkage.scene));
    canvas.look_at_page();
    canvas.text({left.x + 10, left.top() - 16}, say("linkage, @ s", Value(std::floor(time * 10 + 1e-9) / 10, 3)),
                {.size = 22, .anchor = Anchor::left, .bold = true});
    canvas.look(fit({-a, -1.1 * a, 2 * a, 1.35 * a}, right, 8));
    const Point bob = length * from_straight_down<PlaneBody>(pendulum.angle(time));
    pictures::draw(canvas, {.bobs = {{bob, 1}}, .rods = {{{0, 0}, bob}}, .anchors = {{0, 0}}});
    canvas.look_at_page();
    canvas.text({right.centre().x(), right.top() - 16}, say("pendulum of @ m", Value(length, 3)),
                {.size = 20, .colour = palette::theory});
    renderer::draw(canvas, pictures::grown_to(beside, time), lower);
  }
};

}  // namespace

void four_bar_linkage(const Setting& setting, Page& page) {
  const double h = setting.h(), release = radians(setting.angle());
  const FourBarOptions bars = bars_of(setting, release);
  const double length = pendulum_length(bars);
  const SimplePendulum pendulum(release, length, gravity);
  const FourBar start{four_bar(bars), exactly()};
  const Eigen::MatrixXd J = dense_jacobian(start.scene);
  const int numbers = static_cast<int>(J.cols()), rows = static_cast<int>(J.rows()), freedom = numbers - rank(J);

  page.text(
      R"(Two arms (a = @ m long, m_a = @ kg) hang from the ground and carry a coupler (c = @ m, m_c = @ kg) between
      their lower ends: three bodies, four pins.)",
      setting.length, setting.mass, bars.coupler, setting.coupler);
  page.predict(
      {.ask = "How many degrees of freedom does this four-bar linkage have?",
       .answer = static_cast<double>(freedom),
       .unit = "1",
       .tolerance = 0.1,
       .wrong =
           {{4, "That counts the ground as a body with three velocities: 12 − 8. It does not move and has none."},
            {3, "That would be 9 − 6. There are four pins, and each is two rows."},
            {5, "That is 9 − 4. A pin in the plane is two rows, not one."}},
       .hints = {"Count the velocities of the bodies that move, and the rows of the pins.", "velocities − rows.",
                 "3 · 3 − 4 · 2 = …"},
       .right = say("@ velocities less @ rows.", numbers, rows)});
  page.text(
      R"(This linkage *is* a pendulum. The coupler stays level, so it moves as if all its mass were at the arms' ends;
      each arm is a uniform rod about its end, with ⅓ of its mass in the inertia and ½ in the weight. Two arms and a
      coupler therefore swing like a bob on a massless rod of the length)");
  page.formula("ℓ = a (⅔ m_a + m_c)/(m_a + m_c) = @ m",
               R"(\ell = a\,\frac{\tfrac23 m_a + m_c}{m_a + m_c} = @\,\mathrm{m})", length);
  page.derivation("The length of the equivalent pendulum",
                  {{"kinetic energy: two arms about their ends, and the coupler at speed aθ̇",
                    "½ (⅔ m_a + m_c) a² θ̇²", R"(\tfrac12\,(\tfrac23 m_a + m_c)\,a^2\dot\theta^2)"},
                   {"potential energy: each arm's centre at a/2, the coupler at a", "−(m_a + m_c) g a cos θ",
                    R"(-(m_a + m_c)\,g\,a\cos\theta)"},
                   {"a bob m on a rod ℓ has ½mℓ²θ̇² and −mgℓ cos θ; compare the ratio",
                    "ℓ = a (⅔ m_a + m_c)/(m_a + m_c)", R"(\ell = a\,\frac{\tfrac23 m_a + m_c}{m_a + m_c})"}});
  const Swing swing = swing_of(bars, pendulum, h), fine = swing_of(bars, pendulum, h / 2);
  Curve exact{.label = "pendulum, at t + h/2", .style = CurveStyle::theory};
  for (int i = 0; i <= 150; ++i) {
    exact.x.push_back(i * four_bar_seconds / 150);
    exact.y.push_back(degrees(pendulum.angle(exact.x.back() + h / 2)));
  }
  Axis angles{.label = "angle (°)"};
  if (setting.angle >= 30)
    for (int tick = -90; tick <= 90; tick += 30)
      angles.ticks.push_back({static_cast<double>(tick), say("@", tick)});
  page.sequence("four_bar",
                say(R"(The linkage, solved directly (β = 1), and beside it the exact pendulum of @ m. Below: both
          angles.)",
                    Value(length, 3)),
                Seconds{four_bar_seconds},
                [film = FourBarFilm{start,
                                    bars,
                                    pendulum,
                                    h,
                                    {.x = {.label = "time (s)"}, .y = angles, .curves = {swing.angle, exact}}}](
                    Canvas& canvas, double time) mutable { film.draw(canvas, time); });
  const double turn = std::sqrt(gravity / length) * h;  // of the small swing in a step
  const Quantity release_angle("release", setting.angle, "°"), step_angle("ωh", turn);
  const Condition swings = where(release_angle <= 90, step_angle <= 0.06,
                                 Condition{swing.period > 0 && fine.period > 0, "a measurable period"});
  // Near the release angle at which the error of the period changes its sign its order cannot be seen.
  const double error = swing.period - pendulum.period();
  const Condition ordered = where(release_angle <= 60, step_angle <= 0.045,
                                  Condition{swings && std::abs(error) > 0.15 * turn * turn * pendulum.period(),
                                            "an error above 15 % of (ωh)²"});
  page.text(
      R"(The solver does not know that formula. It knows @ rows, and the pins' impulses along the bars keep the coupler
      level. Period: @ s measured over @ s, @ s by the elliptic integral. @)",
      rows, Value(swing.period, 6), measured_for, Value(pendulum.period(), 6),
      ordered ? say("Halving the step divides the difference by @.",
                    Value(error / (fine.period - pendulum.period()), 3))
              : "");
  const Quantity ahead("arms beside the pendulum at t + h/2", degrees(swing.off), "°"),
      late("beside the pendulum at t", degrees(swing.off_at_t), "°");
  page.text(
      R"(To compare the angles, note that symplectic Euler's positions are half a step ahead of the clock, because it
      moves with the velocity at the step's *end*. @)",
      page.verdict(
          {{.when = where(ahead < 2, ahead < late),
            .say = say(R"(Compared with the pendulum at t + h/2 the arms are at most @° off in @ s; compared at
                                t, @°.)",
                       Value(ahead.value, 2), measured_for, Value(late.value, 2))},
           {.when = ahead >= 2,
            .say =
                say(R"(Here the period matters more: it is off by @ %, and within @ s the arms are @° off.)",
                    Value(100 * std::abs(error) / pendulum.period(), 2), measured_for, Value(ahead.value, 2))}}));

  // The errors of a step go with the square of its angle, which is largest at the lowest point.
  const double fastest = std::max(1.0, 2 * (1 - std::cos(release)));
  page.measure("period", swing.period, "s");
  page.claim("degrees of freedom", static_cast<double>(freedom), "1",
             is(1, "nine velocities less eight rows", absolute(0)));
  page.claim("period", swing.period, "s",
             is(pendulum.period(), "elliptic integral, ℓ = a(⅔m_a + m_c)/(m_a + m_c)",
                relative(turn * turn / 3 * fastest)),
             swings);
  page.claim("error of the period, h over h/2", error / (fine.period - pendulum.period()), "1",
             is(4, "second order", absolute(0.7)), ordered);
  page.claim(say("angle beside the pendulum's, largest difference in @ s", measured_for), swing.off, "rad",
             is(0, "elliptic function at t + h/2",
                absolute(turn * turn / 3 * fastest * std::sqrt(gravity / length * fastest) * measured_for)),
             swings);
  page.claim("tilt of the coupler, largest", swing.tilt, "rad",
             is(0, "a parallelogram keeps level", absolute(turn * turn)), swings);
}

}  // namespace byhand::joints
