// Deeper: a box on a lift, a body that is driven.

#include "lessons/05_contact/steps.hpp"
#include "lessons/pictures/boxes.hpp"
#include "lessons/scenes/boxes.hpp"

namespace byhand::contact {
namespace {

constexpr double ride_seconds = 2, part_seconds = 0.4;  // [s]
constexpr double gentle = 0.4, rough = 1.2;             // acceleration of two lifts over g
constexpr double floor_height = 0.2;                    // [m]

/// A box on a lift that speeds up, slows down, comes back in the same way, and stops.
struct Ride {
  double acceleration, h;                                     // [m/s²] > 0, [s]
  int part = std::max(1, int(std::round(part_seconds / h)));  // steps of each of the four
  Simulation<PlaneBody> box{{}, {GaussSeidel{.sweeps = 30, .tolerance = 1e-14}, Baumgarte{}}};
  double velocity = 0;  // of the lift [m/s]
  int steps = 0;

  Ride(double share, double mass, double step) : acceleration(share * gravity), h(step) {
    const int lift = box.scene.add_body(Linear<PlaneBody>(0, -0.5 * floor_height), fixed<PlaneBody>());
    box.scene.set_shape(lift, Box<PlaneBody>{{1.6, floor_height}});
    add_unit_box(box.scene, 0, 0.5, mass);
  }

  /// Of the lift in the next step [m/s²].
  double a() const {
    const int now = steps / part;
    return now > 3 ? 0 : now == 0 || now == 3 ? acceleration : -acceleration;
  }
  void step() {
    const int lift = 0;
    //! [driven]
    velocity += a() * h;
    box.scene.set_velocity(lift, {0, velocity, 0});  // its M⁻¹ is 0: no λ changes it
    box.step(h);
    //! [driven]
    ++steps;
  }
  void go_on(double time) {
    while (box.time < time - 0.5 * h) step();
  }

  /// What the contact presses with [N].
  double force() const {
    double sum = 0;
    for (const Touch<PlaneBody>& touch : box.touches())
      for (const auto& point : touch.points) sum += point.normal_impulse / h;
    return sum;
  }
  double gap() const {
    const auto& pose = box.scene.bodies().pose;
    return pose[1].position.y() - 0.5 - (pose[0].position.y() + 0.5 * floor_height);
  }
  /// How long the lift's acceleration is downwards [s].
  double downwards() const { return 2 * part * h; }
};

/// The gap [m] once the lift no longer accelerates downwards.
double gap_of(Ride ride) {
  while (ride.steps < 3 * ride.part) ride.step();
  return ride.gap();
}

/// ½(a − g)t(t + h) of symplectic Euler [m], or 0 if the box stays on.
double law_of_gap(const Ride& ride) {
  const double t = ride.downwards();
  return 0.5 * std::max(0.0, ride.acceleration - gravity) * t * (t + ride.h);
}

Chart forces_over_time(std::vector<Ride> rides, double weight) {
  Chart chart{.x = {.label = "time (s)", .range = {{0, ride_seconds}}},
              .y = {.label = "λ/h (mg)", .range = {{-0.1, 1.3 * (1 + rough)}}}};
  for (Ride& ride : rides) {
    Curve curve{.label = say("@ g", ride.acceleration / gravity)};
    while (ride.box.time < ride_seconds) {
      ride.step();
      curve.x.push_back(ride.box.time);
      curve.y.push_back(ride.force() / weight);
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = 1, .label = "the weight"});
  return chart;
}

void draw_ride(Canvas& canvas, const Ride& ride, const Rectangle& frame, double weight, int number) {
  canvas.look_at_page();
  canvas.text({frame.centre().x(), frame.top() - 20}, say("a = ±@ g", ride.acceleration / gravity),
              {.size = 22, .colour = palette::series(number), .bold = true});
  const Rectangle below{frame.x, frame.y, frame.width, frame.height - 44};
  canvas.clip(below);
  canvas.look(fit({-1, -0.4, 2, 3.9}, below, 0));
  const pictures::Shapes shapes = pictures::shapes_of(ride.box.scene);
  pictures::draw(canvas, shapes);
  const Point at(0, shapes.boxes[0].at.y() + 0.5 * floor_height);
  if (const double force = ride.force() / weight; force > 1e-9)
    canvas.vector(at, Point(0, std::min(force, 1 + rough)), {palette::force, 0.45, "mg"});
  canvas.clip({});
  canvas.look_at_page();
}

}  // namespace

void on_a_lift(const Setting& setting, Page& page) {
  const double mass = setting.mass, weight = mass * gravity, h = setting.h, a = gentle * gravity;
  const auto ride = [&](double share) { return Ride(share, mass, h); };
  Ride up = ride(gentle);
  up.step();
  const double pressed_up = up.force();
  while (up.steps <= up.part) up.step();
  const double pressed_down = up.force();

  page.text(
      R"(The ground is a body with M⁻¹ = 0. So is a lift, a belt (lesson 6) or a turntable (lesson 7), but it has a velocity: it is *driven*.
      No λ changes that velocity, and each row finds it in its JV.)");
  page.excerpt("lessons/05_contact/on_a_lift.cpp", "driven");
  page.predict(
      {.ask =
           say(R"(A box of @ kg stands on a lift that sets off upwards at a = @ m/s². What does the contact press
                  with, λ/h?)",
               setting.mass, a),
       .answer = pressed_up,
       .unit = "N",
       .tolerance = 0.01 * weight,
       .wrong = {{weight, "That is at rest, and at any steady speed."},
                 {mass * a, "That speeds the box up, but does not carry it."},
                 {weight - mass * a, "That is when the lift slows down on its way up."}},
       .hints = {"Which acceleration has the box, if it stays on the lift?", "λ/h − mg = ma.",
                 say("@ · (@ + @) N = …", setting.mass, gravity, a)},
       .right = "The row finds an approach of (g + a)h in each step and stops it: λ/h = m(g + a)."});
  const std::vector<Ride> rides{ride(gentle), ride(rough)};
  page.sequence(
      "lift",
      say(R"(A lift goes up and comes back, with an acceleration of @ g or @ g. Orange: λ/h. Right: the same in units
          of the weight; the landing goes off the chart.)",
          gentle, rough),
      Seconds{ride_seconds},
      [rides = rides, weight, forces = forces_over_time(rides, weight)](Canvas& canvas, double time) mutable {
        const auto [left, right] = canvas.page().inset(14).panels(0.5, 16);
        const auto frames = left.cells(1, static_cast<int>(rides.size()), 8);
        for (std::size_t i = 0; i < rides.size(); ++i) {
          rides[i].go_on(time);
          draw_ride(canvas, rides[i], frames[i], weight, static_cast<int>(i));
        }
        renderer::draw(canvas, pictures::grown_to(forces, rides.front().box.time), right.lowered(50));
      });
  const double stays = gap_of(rides[0]), leaves = gap_of(rides[1]);
  page.text(
      R"(No row holds an acceleration: it is how the lift's velocity changes from step to step. Where it is below −g,
      the box does not approach the lift, λ = 0, and the contact opens:)");
  page.formula("λ/h = m(g + a) for a ≥ −g;   for a < −g,  C = ½(|a| − g) t (t + h) after a time t",
               R"(\frac{\lambda}{h} = m(g + a) \ \text{ for } a \ge -g, \qquad
                  C = \tfrac12(|a| - g)\,t\,(t+h) \ \text{ after } t \text{ for } a < -g)");
  page.text(page.verdict(
      {{.when = where(Quantity(say("gap at @ g", gentle), stays, "m") < 1e-9,
                      Quantity(say("gap at @ g", rough), leaves, "m") > 1e-3),
        .say = say("With ±@ g the box stays on. With ±@ g it is @ m above the lift after @ s of a < −g.", gentle,
                   rough, Value(leaves, 3), Value(rides[1].downwards(), 3))}}));
  page.claim("λ/h while the lift speeds up", pressed_up, "N", is(weight + mass * a, "m(g + a)", relative(1e-9)));
  page.claim("λ/h while it slows down", pressed_down, "N", is(weight - mass * a, "m(g − a)", relative(1e-9)));
  for (const double share : {0.999, 1.001, rough})
    page.claim(say("gap after slowing down at @ g", share), without_rounding(gap_of(ride(share)), 1), "m",
               is(law_of_gap(ride(share)), share < 1 ? "it stays on" : "½(a − g)t(t + h)", absolute(1e-9)));
}

}  // namespace byhand::contact
