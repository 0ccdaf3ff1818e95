// Step 6: a motor, a crank, a rod and a piston.

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/06_joints/runs.hpp"
#include "lessons/06_joints/steps.hpp"
#include "lessons/exact/slider_crank.hpp"
#include "lessons/scenes/slider_crank.hpp"

namespace byhand::joints {
namespace {

using Machine = Simulation<PlaneBody>;

constexpr double crank_turns = 1.5;  // of the crank, watched
constexpr double start = 0.3;        // of the crank [rad]
enum Body { ground, crank, rod, piston };
constexpr int motor_row = 4;

SliderCrankOptions options_of(const Setting& setting) {
  SliderCrankOptions machine;
  machine.crank = setting.crank;
  machine.rod = setting.length;
  machine.crank_mass = machine.rod_mass = machine.piston_mass = setting.mass;
  machine.speed = setting.speed;
  machine.strength = 1e9;
  machine.angle = start;
  return machine;
}

Machine machine_of(const SliderCrankOptions& options) { return {slider_crank(options), exactly()}; }

/// Kinetic energy of the whole machine over ½ω², a moment of inertia that the crank's angle decides [kg m²].
double inertia_at(const SliderCrankOptions& machine, double angle) {
  const SliderCrank exact(machine.crank, machine.rod);
  const double r = machine.crank, x = r * std::cos(angle), y = r * std::sin(angle);
  const double rod_speed = -x / std::sqrt(machine.rod * machine.rod - y * y), slide = exact.speed(angle);
  const Point middle((slide - y) / 2, x / 2);  // velocity of the rod's centre over ω
  return machine.crank_mass * r * r / 3 + machine.piston_mass * slide * slide +
         machine.rod_mass * (middle.squaredNorm() + std::pow(machine.rod * rod_speed, 2) / 12);
}

/// The motor's torque at a steady speed: τω is what the kinetic energy gains [N m].
double torque_at(const SliderCrankOptions& machine, double angle) {
  const double d = 1e-5;
  return 0.5 * machine.speed * machine.speed * (inertia_at(machine, angle + d) - inertia_at(machine, angle - d)) /
         (2 * d);
}

/// What the machine did, beside its closed form.
struct Run {
  Curve position{}, torque{};
  double position_off = 0, torque_off = 0, speed_off = 0;  // largest [m], [N m], [rad/s]
};

Run run_of(const SliderCrankOptions& options, double h) {
  const SliderCrank exact(options.crank, options.rod);
  Machine machine = machine_of(options);
  Run run{.position = {.label = "run"}, .torque = {.label = "run"}};
  const double end = crank_turns * 2 * pi / options.speed;
  advance_to(machine, end, h, [&] {
    const double angle = options.angle + options.speed * machine.time;
    const double x = machine.scene.bodies().pose[piston].position.x();
    const double torque = machine.reaction(motor_row).torque2[0];
    run.position_off = std::max(run.position_off, std::abs(x - exact.position(angle)));
    run.speed_off = std::max(run.speed_off, std::abs(machine.scene.bodies().velocity[crank][2] - options.speed));
    // An impulse changes V from the middle of the last step to that of this one. The run starts
    // without drift, and its first steps build it up.
    if (machine.time > 10 * h)
      run.torque_off = std::max(run.torque_off, std::abs(torque - torque_at(options, angle - options.speed * h)));
    run.position.x.push_back(machine.time);
    run.position.y.push_back(x);
    run.torque.x.push_back(machine.time - h);  // the time of the poses whose rows were solved
    run.torque.y.push_back(machine.time > 3.5 * h ? torque : NAN);
  });
  return run;
}

struct CrankFilm {
  Machine machine;
  SliderCrankOptions options;
  double h;
  Chart position, torque;

  void draw(Canvas& canvas, double time) {
    advance_to(machine, time, h);
    const auto [upper, lower] = canvas.page().inset(14).split_rows(0.46, 8);
    const double r = options.crank, l = options.rod;
    const auto& pose = machine.scene.bodies().pose;
    canvas.look(fit({-1.3 * r, -1.3 * r, l + 3.1 * r, 2.6 * r}, upper, 4));
    canvas.clip(upper);
    draw_rail(canvas, {l, -0.36 * r}, 0, 1.5 * r);
    draw_rail(canvas, {l, 0.36 * r}, 0, 1.5 * r);
    canvas.anchor({0, 0});
    canvas.box(pose[piston].position, {0.6 * r, 0.6 * r}, 0);
    draw_bar(canvas, bar_of(pose[rod], l), 14);
    draw_bar(canvas, bar_of(pose[crank], r), 18);
    for (const Point& at : {bar_of(pose[crank], r).from, bar_of(pose[rod], l).from, bar_of(pose[rod], l).to})
      canvas.hinge(at);
    if (machine.time > 0) {
      const double given = machine.reaction(motor_row).torque2[0], most = ranges(torque).y.second,
                   along = std::atan2(pose[crank].rotation.sin, pose[crank].rotation.cos);
      if (std::abs(given) > 0.02 * most)
        draw_turn(canvas, {0, 0}, along, along + std::clamp(2 * given / most, -1.4, 1.4), 0.6 * r,
                  {palette::force, 4});
    }
    canvas.clip({});
    canvas.look_at_page();
    const auto charts = lower.cells(1, 2, 20);
    renderer::draw(canvas, pictures::grown_to(position, time), charts[0]);
    renderer::draw(canvas, pictures::grown_to(torque, time), charts[1]);
  }
};

}  // namespace

void driven_crank(const Setting& setting, Page& page) {
  const SliderCrankOptions options = options_of(setting);
  const SliderCrank exact(options.crank, options.rod);
  const double h = setting.h(), r = options.crank, l = options.rod, end = crank_turns * 2 * pi / options.speed;
  const double turn = options.speed * h;
  const Run run = run_of(options, h), fine = run_of(options, h / 2);

  page.text(
      R"(Pins, a slider and a motor in one machine: the motor turns a crank of @ m at @ rad/s, a rod of @ m joins it by
      two pins to a piston, and a slider guides the piston. Three bodies of @ kg have nine velocities; three pins and a
      slider take eight of them, and the motor's row takes the last. So the motion is fixed, and all of it has a closed
      form.)",
      setting.crank, setting.speed, setting.length, setting.mass);
  // Whether the motor brakes, by its closed form, while the piston slows down.
  int braking = 0, slowing = 0;
  for (double angle = 0.005; angle < pi; angle += 0.01) {
    if (std::abs(exact.speed(angle + 0.005)) >= std::abs(exact.speed(angle - 0.005))) continue;
    ++slowing;
    braking += torque_at(options, angle) < 0 ? 1 : 0;
  }
  page.choose(
      {.ask = "There is no gravity, and the crank keeps its speed. When does the motor brake?",
       .options = {{"while the piston speeds up", "There the motor has to give the energy that the piston gains."},
                   {"while the piston slows down",
                    "Its energy goes back through the rod and the crank into the motor."},
                   {"never", "Then the piston could not lose the energy that it has gained."}},
       .answer = 2 * braking > slowing ? 1 : 0,
       .hints = {"The crank's energy stays the same. Whose does not?",
                 "Power = torque times ω = the change of the whole machine's kinetic energy.",
                 "Where does the piston lose kinetic energy, and where does that go?"}});
  page.formula("x = r cos θ + √(l² − r² sin² θ),   θ = θ₀ + ωt,   τ = ½ω² dI/dθ",
               R"(x = r\cos\theta + \sqrt{l^2 - r^2\sin^2\theta},\quad \theta = \theta_0 + \omega t,\quad
                  \tau = \tfrac12\omega^2\,\frac{dI}{d\theta})");
  page.text(
      R"(I(θ) is the machine's kinetic energy divided by ½ω²: the crank's own @ kg m², and a part of the rod and the
      piston that depends on the angle. Where I(θ) rises the motor gives energy, where it falls the motor takes it
      back.)",
      Value(options.crank_mass * r * r / 3, 3));
  page.derivation("The motor's torque",
                  {{"kinetic energy at a steady ω", "E = ½ I(θ) ω²", R"(E = \tfrac12\,I(\theta)\,\omega^2)"},
                   {"the motor's power is the change of E (without gravity)", "τω = dE/dt = ½ω² dI/dθ · ω",
                    R"(\tau\,\omega = \dot E = \tfrac12\omega^2\,\frac{dI}{d\theta}\,\omega)"},
                   {"divide by ω", "τ = ½ ω² dI/dθ", R"(\tau = \tfrac12\,\omega^2\,\frac{dI}{d\theta})"}});

  double peak = 0, most = 0;  // of the closed form, of the run
  Curve position{.label = "closed form", .style = CurveStyle::theory}, torque = position;
  for (int i = 0; i <= 240; ++i) {
    const double t = i * end / 240, angle = start + options.speed * t;
    position.x.push_back(t);
    position.y.push_back(exact.position(angle));
    torque.x.push_back(t);
    torque.y.push_back(torque_at(options, angle));
    peak = std::max(peak, std::abs(torque.y.back()));
  }
  for (const double given : run.torque.y)
    if (std::isfinite(given)) most = std::max(most, std::abs(given));
  const double shown = std::max(1.3 * peak, 1.05 * most);
  CrankFilm film{machine_of(options),
                 options,
                 h,
                 {.x = {.label = "time (s)"}, .y = {.label = "piston (m)"}, .curves = {run.position, position}},
                 {.x = {.label = "time (s)"},
                  .y = {.label = "motor's torque (N m)", .range = {{-shown, shown}}},
                  .curves = {run.torque, torque}}};
  page.sequence("slider_crank",
                R"(One turn and a half of the crank, all rows solved at once (β = 1). Orange: the motor's torque.
                Dashed: the closed forms.)",
                Seconds{std::min(end, 3.0)},
                [film](Canvas& canvas, double time) mutable { film.draw(canvas, time); });
  const Condition calm = both(Quantity("ωh", turn) <= 0.15, Quantity("l/r", l / r) >= 1.5);
  const Quantity off("off/r", run.position_off / r);
  page.text(
      R"((The first steps of the torque are not drawn: it jumps until the drift has built up.) Up to rounding the
      crank keeps its target speed: a motor with enough strength is a row like any other. @)",
      page.verdict(
          {{.when = both(calm, off < 0.1),
            .say = say(
                R"(The piston is at most @ mm off, with half the step @ mm: the error of stepping along the tangent,
                which
                       is proportional to (ωh)², and ωh = @.)",
                Value(1000 * run.position_off, 3), Value(1000 * fine.position_off, 3), Value(turn, 3))},
           {.when = off < 0.1,
            .say = say("The piston is at most @ mm off, with half the step @ mm.",
                       Value(1000 * run.position_off, 3), Value(1000 * fine.position_off, 3))},
           {.when = off >= 0.1,
            .say = say(
                R"(But the piston is up to @ mm off, on a crank of @ m: the machine comes apart. ωh = @ is far too long
                a step for it.)",
                Value(1000 * run.position_off, 3), setting.crank, Value(turn, 2))}}));

  page.measure("piston off at most", 1000 * run.position_off, "mm");
  page.claim("crank's speed, largest difference", run.speed_off, "rad/s",
             is(0, "the motor's own row", absolute(1e-9 * options.speed)));
  page.claim("piston beside its closed form, largest difference", run.position_off, "m",
             is(0, "r cos θ + √(l² − r² sin² θ)", absolute(turn * turn * r)), calm);
  page.claim("the same, h over h/2", run.position_off / fine.position_off, "1", is(4, "second order", absolute(1)),
             calm);
  page.claim("motor's torque beside its closed form, after ten steps, largest difference over the peak",
             run.torque_off / peak, "1", is(0, "½ω² dI/dθ", absolute(3 * turn * turn)), calm);
}

}  // namespace byhand::joints
