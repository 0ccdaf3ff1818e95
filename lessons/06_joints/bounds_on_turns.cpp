// Step 5: stops and motors, which are one row between two bounds.

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/pictures/acts.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"

namespace byhand::joints {
namespace {

using Held = Simulation<PlaneBody>;

constexpr double bar_seconds = 1.6, bar_settles = 6;  // [s]
constexpr double weak_settles = 40;                   // √(L/g)
constexpr double stop_at = pi / 4, enough = 0.6;      // below level [rad]; a motor that can hold [mgl]

/// A uniform bar hinged at the origin, at rest at an angle below level [rad].
Held arm(const Setting& setting, double below) {
  return {hinged_rod(pi / 2 - below, setting.length, setting.mass), exactly()};
}

Turn<PlaneBody> turn_of(const Held& arm) { return turn<PlaneBody>(arm.scene.bodies(), 0, 1); }

double weight_torque(const Setting& setting) { return setting.mass * gravity * setting.length; }

/// An arm that a motor of some strength [mgl] tries to hold where it is.
Held held(const Setting& setting, double strength, double below = 0) {
  Held held = arm(setting, below);
  held.scene.add(motor<PlaneBody>(turn_of(held), 0, strength * weight_torque(setting)));
  return held;
}

Held arm_on_stop(const Setting& setting) {
  Held arm_on_stop = arm(setting, 0);
  arm_on_stop.scene.add(at_least<PlaneBody>(-stop_at, turn_of(arm_on_stop)));
  return arm_on_stop;
}

/// Below level [rad].
double below_level(const Held& arm) {
  const auto& rotation = arm.scene.bodies().pose[1].rotation;
  return std::atan2(rotation.cos, rotation.sin);
}

/// What the bounded row gives [mgl].
double torque(const Held& arm, const Setting& setting) {
  return arm.time == 0 ? 0 : arm.reaction(1).torque2[0] / weight_torque(setting);
}

/// Where a brake of that strength [mgl] has used up what gravity gave: ½ sin φ = s φ [rad].
double braked_at(double strength) {
  double low = 1e-6, high = pi;
  for (int i = 0; i < 60; ++i) {
    const double middle = (low + high) / 2;
    (0.5 * std::sin(middle) > strength * middle ? low : high) = middle;
  }
  return (low + high) / 2;
}

/// Where a motor of that strength [mgl], told to stand still, holds a bar that was let go level [rad], and in how
/// many half swings: from one turning point φ to the next, gravity gives ½(sin φ′ − sin φ) and the motor takes s
/// |φ′ − φ|.
struct Rest {
  double angle = 0;
  int half_swings = 0;
};

Rest rest_by_energy(double strength) {
  Rest rest;
  while (0.5 * std::abs(std::cos(rest.angle)) > strength) {
    const double from = rest.angle, way = from < pi / 2 ? 1 : -1;                    // downwards
    double near = way > 0 ? std::acos(2 * strength) : pi - std::acos(2 * strength);  // the fastest
    double far = way > 0 ? pi : 0;
    for (int i = 0; i < 60; ++i) {
      const double middle = (near + far) / 2;
      const double left = 0.5 * (std::sin(middle) - std::sin(from)) - strength * std::abs(middle - from);
      (left > 0 ? near : far) = middle;
    }
    rest.angle = (near + far) / 2;
    ++rest.half_swings;
  }
  return rest;
}

struct Shown {
  std::string name;
  Held arm;
};

struct BarsFilm {
  std::vector<Shown> shown;
  Setting setting;
  Chart beside;

  void draw(Canvas& canvas, double time) {
    const double length = setting.length, h = setting.h();
    const auto [upper, lower] = canvas.page().inset(14).split_rows(0.56, 8);
    const auto cells = upper.cells(1, static_cast<int>(shown.size()), 10);
    for (std::size_t i = 0; i < shown.size(); ++i) {
      Held& arm = shown[i].arm;
      advance_to(arm, time, h);
      const TextStyle bold{.size = 20, .colour = palette::series(static_cast<int>(i)), .bold = true};
      const std::string name = pictures::wrapped(canvas, shown[i].name, cells[i].width, bold);
      canvas.text({cells[i].centre().x(), cells[i].top() - (name == shown[i].name ? 14 : 26)}, name, bold);
      const Rectangle below{cells[i].x, cells[i].y, cells[i].width, cells[i].height - 34};
      canvas.look(fit({-0.75 * length, -1.1 * length, 1.9 * length, 1.5 * length}, below, 4));
      if (i == 0) draw_stop(canvas, {0, 0}, -stop_at, length);
      canvas.anchor({0, 0}, {0, -1});
      draw_bar(canvas, {{0, 0}, 2 * arm.scene.bodies().pose[1].position}, 16,
               pictures::look_of_run(static_cast<int>(i)));
      canvas.hinge({0, 0});
      const double given = std::min(torque(arm, setting), 1.0), phi = -below_level(arm),
                   aside = given > 0 ? -0.12 : 0.12;
      if (std::abs(given) > 0.01)
        draw_turn(canvas, {0, 0}, phi + aside - 3 * given, phi + aside, 0.42 * length, {palette::force, 4});
      canvas.look_at_page();
    }
    renderer::draw(canvas, pictures::grown_to(beside, time), lower);
  }
};

}  // namespace

void bounds_on_turns(const Setting& setting, Page& page) {
  const double h = setting.h(), strength = setting.strength();
  page.text(
      R"(A stop and a motor share one row, the turn's J = [0 −1 0 1], and for both the solver clamps the sum of λ to an
      interval, as for a contact (lesson 5, step 1). They differ in the interval and the speed they ask for (b is a
      contact's: C/h before the stop, (β/h)C beyond it):)");
  page.formula("stop:  JV + b ≥ 0,  λ ≥ 0        motor:  JV = s,  |λ| ≤ τh",
               R"(\text{stop: } JV + b \ge 0,\ \lambda \ge 0 \qquad
                  \text{motor: } JV = s,\ |\lambda| \le \tau h)");
  page.text(
      R"(The bound is on the *impulse* of a step, so a strength in N m is multiplied by h. (Without the h a motor would be
      twice as strong at twice the frame rate.) Take a bar of @ m and @ kg, hinged at one end and released level.
      Holding it there takes mgl/2 = @ N m.)",
      setting.length, setting.mass, 0.5 * weight_torque(setting));

  const double law = braked_at(strength), balance = strength < 0.5 ? std::acos(2 * strength) : 0;
  const double settles = weak_settles * std::sqrt(setting.length / gravity);
  const Held weak = held(setting, strength), at_rest = after(weak, settles, h);
  const double found = below_level(at_rest);
  const Rest rest = rest_by_energy(strength);
  const double needs = 0.5 * std::abs(std::cos(law));  // to hold the bar where the brake first stops it [mgl]
  const double answer = degrees(rest.angle), tolerance = 3;
  std::vector<WrongAnswer> wrong;
  const auto expect = [&](double angle, const char* reply) {
    if (std::abs(angle - answer) > 2 * tolerance) wrong.push_back({angle, reply});
  };
  expect(degrees(balance),
         R"(There its strength balances the weight's torque. But the bar arrives at speed and swings
                           farther before it has lost it.)");
  expect(90, "It would with a damper, whose torque vanishes as the bar slows down. This torque does not.");
  expect(0, "Holding it level takes mgl/2, and the motor has less.");
  if (rest.half_swings > 1)
    expect(degrees(law), "It stops there first, but holding it there takes more than the motor has.");
  page.predict(
      {.ask = say(
           R"(A motor of at most @ mgl is told to hold the bar (s = 0). It is too weak. How many degrees below level
           does the bar come to rest?)",
           setting.strength),
       .answer = answer,
       .unit = "°",
       .tolerance = tolerance,
       .wrong = wrong,
       .hints =
           {"At its bound the motor is a brake of constant torque. Compare two energies.",
            "Gravity's work is ½mgl sin φ; the brake's is τφ.",
            rest.half_swings == 1
                ? say("½ sin φ = @ φ, with φ in radians.", setting.strength)
                : say(R"(½ sin φ = @ φ gives @°, and the bar swings back if ½|cos φ| > @ there. From one turning
                           point φ to the next, φ′: ½(sin φ′ − sin φ) = @ |φ′ − φ|.)",
                      setting.strength, Value(degrees(law), 4), setting.strength, setting.strength)},
       .hinted = answer,
       .right = rest.half_swings == 1
                    ? say("½ sin φ = @ φ has the solution φ = @°.", setting.strength, Value(degrees(law), 4))
                    : say("It comes to rest after @ half swings, the first of them to @°.", rest.half_swings,
                          Value(degrees(law), 4))});
  const std::vector<Shown> shown{{say("stop at @°", Value(degrees(stop_at), 3)), arm_on_stop(setting)},
                                 {say("motor of @ mgl", enough), held(setting, enough)},
                                 {say("motor of @ mgl", setting.strength), weak}};
  Chart chart{.x = {.label = "time (s)", .range = {{0, bar_seconds}}},
              .y = {.label = "torque (mgl)", .range = {{-0.25, 1}}}};
  for (const Shown& one : shown) {
    Curve curve{.label = one.name};
    Held now = one.arm;
    constexpr double beyond = 2;  // [mgl], beyond the chart
    bool cut = false;
    advance_to(now, bar_seconds, h, [&] {
      const double given = std::min(torque(now, setting), beyond);
      if (given == beyond || cut) {  // upright, one step wide
        curve.x.push_back(now.time - (cut ? h : 0));
        curve.y.push_back(cut ? given : curve.y.back());
      }
      cut = given == beyond;
      curve.x.push_back(now.time);
      curve.y.push_back(given);
    });
    chart.curves.push_back(curve);
  }
  chart.references.push_back({Reference::Across::y, 0.5, "the weight's torque, level"});
  page.sequence(
      "stop_and_motors",
      say(R"(Three bars let go level: one has a stop @° below, one a strong motor, one the weak motor. Their torques
          (λ/h; the stop's impact goes off the chart) in the first @ s, also drawn as arrows.)",
          Value(degrees(stop_at), 3), bar_seconds),
      Seconds{bar_seconds},
      [film = BarsFilm{shown, setting, chart}](Canvas& canvas, double time) mutable { film.draw(canvas, time); });
  const Quantity needed("½|cos φ|", needs), available("τ/mgl", strength);
  page.text(
      R"(**A motor told to stand still, with a bound, is dry friction in the joint.** All the way down its λ is at the
      bound, so it takes the energy τφ; gravity gives ½mgl sin φ. They are equal at @°, @ the lowest point. Holding
      the bar there takes @ mgl. @ If you *set the bar down gently*, it already stays from arccos(2τ/mgl) = @° on.)",
      Value(degrees(law), 4), law > pi / 2 ? "beyond" : "short of", Value(needs, 3),
      page.verdict(
          {{.when = needed <= available, .say = "The motor has that much, so the bar stays."},
           {.when = needed > available,
            .say = say(R"(That is more than the motor has, so the bar swings back, less far each time: it rests
                                after @ half swings, at @°.)",
                       rest.half_swings, Value(answer, 4))}}),
      Value(degrees(balance), 4));
  const Held on_stop = after(shown[0].arm, bar_settles, h), holds = after(shown[1].arm, bar_settles, h);
  page.text(
      R"(The stop gives nothing for @°, one large impulse when the bar arrives, and then the torque of the bar's weight:
      ½mgl cos @° = @ mgl. The strong motor gives exactly the weight's torque and not its full strength: a bound is just
      a limit. The weak motor is at its limit while the bar moves.)",
      Value(degrees(stop_at), 3), Value(degrees(stop_at), 3), Value(torque(on_stop, setting), 4));
  page.table({"One kind of row, seven machines", "JV is", "asks for", "λ within"},
             {{"dry friction in a joint", "ω₂ − ω₁", "0", "±τh"},
              {"a conveyor belt", "slip along t at a contact", "the belt's speed", "±μλₙ"},
              {"rolling resistance, with the lever a", "ω₂ − ω₁ of a wheel on the ground", "0", "±aλₙ"},
              // ∫ μpr dA with p = N/πR², even: ⅔μRN. Under a ball (Hertz, p ∝ √(1 − r²/R²)) it is 3π/16 · μRN.
              {"drilling by a disc of radius R that presses evenly, in space", "n·(ω₂ − ω₁)", "0", "±⅔μRλₙ"},
              {"two external gears", "r₁ω₁ + r₂ω₂", "0", "no bound"},
              {"a rack and pinion", "t·v₂ − r₁ω₁", "0", "no bound"},
              {"a screw of lead p, in space", "a·v − (p/2π) a·ω", "0", "no bound"}});
  page.measure("the weak motor's bar, below level", degrees(found), "°");
  page.claim("where the weak motor holds the bar, below level", found, "rad",
             is(rest.angle, "½(sin φ′ − sin φ) = (τ/mgl) |φ′ − φ|, half swing by half swing",
                absolute(rest.half_swings * (2 * h * h * gravity / setting.length + 1e-3))),
             Quantity("gh²/L", h * h * gravity / setting.length) < 0.01);
  for (const double share : {0.98, 1.02}) {
    const double set_down = balance / share;
    const bool stays = share < 1;
    const double moves = std::abs(below_level(after(held(setting, strength, set_down), 2, h)) - set_down);
    page.claim(say("set down gently at @°, it moves in two seconds by", Value(degrees(set_down), 4)), moves, "rad",
               is(stays ? 1e-9 : balance - set_down,
                  stays ? "½ cos φ < τ/mgl: it stays" : "½ cos φ > τ/mgl: it swings past the balance",
                  stays ? at_most() : at_least()),
               Quantity("strength", strength, "mgl") <= 0.45);
  }
  page.claim("what the stop carries at rest", torque(on_stop, setting), "mgl",
             is(0.5 * std::cos(stop_at), "½ cos φ", absolute(1e-3)));
  page.claim("what the strong motor gives", torque(holds, setting), "mgl",
             is(0.5, "the weight's torque", absolute(1e-9)));
}

}  // namespace byhand::joints
