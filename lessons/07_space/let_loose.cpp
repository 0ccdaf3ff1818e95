// Deeper: found contacts in space: a book that is thrown, bounces and tumbles.

#include "lessons/07_space/steps.hpp"
#include "lessons/pictures/space_scene.hpp"
#include "lessons/scenes/boxes.hpp"
#include "solver/constraints/contact.hpp"

namespace byhand::space {
namespace {

using Loose = Simulation<SpaceBody>;

constexpr double tumble_seconds = 3, patience = 30, slop = 1e-3;  // [s], [s], [m]

/// A book above or on the ground, 60 sweeps a step, turning as the implicit term has it.
Loose on_the_ground(const Setting& setting, const Pose<SpaceBody>& pose, const Velocity<SpaceBody>& velocity,
                    double restitution = 0) {
  Loose loose{{}, {GaussSeidel{60}, Baumgarte{.beta = 0.2, .slop = slop}}};
  loose.method.gyroscopic = Gyroscopic::implicit;
  const Surface surface{.friction = setting.friction, .restitution = restitution};
  add_ground(loose.scene, surface);
  const int book = add_box(loose.scene, pose, setting.mass, Linear<SpaceBody>(book_sides()), surface);
  loose.scene.set_velocity(book, velocity);
  return loose;
}

/// Lying flat, its shortest side upright.
Pose<SpaceBody> lying() {
  Pose<SpaceBody> pose;
  pose.rotation = space_rotation(Angular<SpaceBody>(pi / 2, 0, 0));
  pose.position.y() = 0.5 * book_sides().z();
  return pose;
}

constexpr double thrown_from = 1.2, fall = 0.3;       // [m], speed downwards over that forwards
Eigen::Vector3d thrown_spin() { return {2, 1, -9}; }  // [rad/s]

Loose tumbling(const Setting& setting) {
  Pose<SpaceBody> pose;
  pose.position = {0, thrown_from, 0};
  pose.rotation = space_rotation(Angular<SpaceBody>(0.4, 0.3, 0.5));
  Velocity<SpaceBody> V;
  V << setting.speed, 0, -fall * setting.speed, thrown_spin();
  return on_the_ground(setting, pose, V, 0.4);
}

/// How far a flat book gets, and when it comes to rest, if it also spins at `spin` [rad/s] about the vertical.
struct Stop {
  double distance, time;  // [m], [s]
};
Stop slid(const Setting& setting, double speed, double spin) {
  Velocity<SpaceBody> V = Velocity<SpaceBody>::Zero();
  V[0] = speed;
  V[4] = spin;
  auto book = on_the_ground(setting, lying(), V);
  const auto& bodies = book.scene.bodies();
  while (bodies.velocity[1].norm() > 1e-3 && book.time < 30) book.step(setting.h);
  return {bodies.pose[1].position.x(), book.time};
}

struct TumbleFilm {
  std::vector<double> time;
  std::vector<Pose<SpaceBody>> pose;
  Chart beside;

  void draw(Canvas& canvas, double now) const {
    const auto [above, under] = canvas.page().inset(16).split_rows(0.62, 8);
    std::size_t last = 0;
    while (last + 1 < time.size() && time[last + 1] <= now + 1e-9) ++last;
    const double way = (pose.back().position - pose.front().position).norm();
    const double reach = std::max(1.5, (0.5 * way + 1.3) * above.height / above.width);
    Point3 middle = 0.5 * (pose.back().position + pose.front().position);
    middle.y() = 0.5;
    Space space(pictures::from_aside(middle, reach, above, 0.25, 0.3));
    space.ground({middle.x(), 0, middle.z()}, way + 2, 0.5);
    std::vector<Point3> trail;
    for (std::size_t i = 0; i <= last; i += 3) trail.push_back(pose[i].position);
    pictures::add_trail(space, trail, 0.02, palette::velocity);
    pictures::add_book(space, pose[last], book_sides());
    canvas.draw(space);
    canvas.text({above.x + 4, above.top() - 14}, say("@ s", Value(std::floor(now * 10 + 1e-6) / 10, 3)),
                {.size = 22, .anchor = renderer::Anchor::left, .bold = true});
    renderer::draw(canvas, pictures::grown_to(beside, now), under);
  }
};

/// What a tumbling book shows.
struct Tumble {
  TumbleFilm film;
  bool rests = false;   // whether it has come to rest
  double speed = 0;     // at the end of the film [m/s]
  double rises = 0;     // the largest rise of its energy in a step, over its first energy
  double pressed = 0;   // the ground's push at the end, over the weight [1]
  double flatness = 0;  // the largest |cosine| between an axis of the book and the vertical, at the end
  double deepest = 0;   // overlap at the end [m]
};
Tumble tumble(const Setting& setting) {
  Tumble tumble;
  auto book = tumbling(setting);
  const auto& bodies = book.scene.bodies();
  Curve total;
  double still = 0;  // for how long it has not moved [s]
  for (const double h = setting.h; book.time <= tumble_seconds || (still < 1 && book.time < patience);
       book.step(h)) {
    still = bodies.velocity[1].norm() < 1e-6 ? still + h : 0;
    if (book.time > tumble_seconds + h) continue;
    tumble.film.time.push_back(book.time);
    tumble.film.pose.push_back(bodies.pose[1]);
    tumble.speed = bodies.velocity[1].head<3>().norm();
    total.x.push_back(book.time);
    // With the velocity of half a step on, of which symplectic Euler keeps the energy in flight.
    total.y.push_back(energy(book.scene) - 0.5 * setting.mass * gravity * h * bodies.velocity[1].y());
    if (total.y.size() > 1)
      tumble.rises = std::max(tumble.rises, (total.y.back() - total.y[total.y.size() - 2]) / total.y.front());
  }
  tumble.rests = still > 0;
  const double lies = setting.mass * gravity * 0.5 * book_sides().z();
  Axis energies{.label = "energy (J)", .range = {{0, 1.05 * *std::max_element(total.y.begin(), total.y.end())}}};
  for (int tick = 0; tick < energies.range->second; tick += 20)
    energies.ticks.push_back({static_cast<double>(tick), say("@", tick)});
  tumble.film.beside = {.x = {.label = "time (s)", .range = {{0, tumble_seconds}}},
                        .y = energies,
                        .curves = {total},
                        .references = {{.value = lies}}};
  for (const Touch<SpaceBody>& touch : book.touches())
    for (const auto& point : touch.points)
      tumble.pressed += point.normal_impulse / (setting.mass * gravity * setting.h);
  tumble.flatness = bodies.pose[1].rotation.toRotationMatrix().row(1).cwiseAbs().maxCoeff();
  tumble.deepest = position_error(book).max;
  return tumble;
}

constexpr double heavy = 100, settling = 8;  // mass of the upper cube over the lower, [s]

/// How far the upper of two unit cubes is off its place, at most, in the last second of `settling` [m].
double off_its_place(const RowSolver& solver, double h) {
  Loose pair{stack<SpaceBody>(2, heavy), {solver, Baumgarte{.beta = 0.2}}};
  double worst = 0;
  while (pair.time < settling - 0.5 * h) {
    pair.step(h);
    if (pair.time > settling - 1)
      worst = std::max(worst, std::abs(pair.scene.bodies().pose[2].position.y() - 1.5));
  }
  return worst;
}

}  // namespace

void let_loose(const Setting& setting, Page& page) {
  const Tumble thrown = tumble(setting);
  page.text(
      R"(Now the solver finds the contacts: in every step it looks for the points where shapes touch, and each gets a
      contact and two rows of friction. Throw a book from a height of @ m, at @ m/s forward and @ m/s down, spinning
      at @ rad/s, μ = @.)",
      thrown_from, setting.speed, fall * setting.speed, Value(thrown_spin().norm(), 2), setting.friction);
  page.sequence(
      "tumbling",
      say(R"(The thrown book bounces, and tumbles over corners and edges@. Below: its energy (with the velocity at the
          time of the position; dotted: lying flat), which impacts and friction take away@.)",
          thrown.speed > 0.01 ? say("; after @ s it is still moving", tumble_seconds)
          : thrown.rests      ? std::string(", and comes to rest in the end")
                              : std::string(),
          thrown.rises > 1e-3 ? say("; where it rises, by up to @ % in a step, β pushes an overlap out",
                                    Value(100 * thrown.rises, 2))
                              : std::string()),
      Seconds{tumble_seconds}, [film = thrown.film](Canvas& canvas, double time) { film.draw(canvas, time); });

  const double speed = setting.speed, a = setting.friction * gravity;
  const double half_diagonal = 0.5 * std::hypot(book_sides().x(), book_sides().y());
  const double spin = speed / half_diagonal;
  const Stop straight = slid(setting, speed, 0), spinning = slid(setting, speed, spin),
             whirl = slid(setting, 0, spin);
  page.text(
      R"(Friction at four corners also brakes a spin. If the book lies flat and only spins, at ω = v/r = @ rad/s, each
      corner slips at the same @ m/s, at right angles to its arm r = @ m. (Four corners on a plane are one row too many,
      so their loads are not determined: lesson 6, step 4. This solver lets them share the weight equally.) Then each
      has a friction of μmg/4, the torque is μmgr, and with I = mr²/3)",
      Value(spin, 4), setting.speed, Value(half_diagonal, 4));
  page.formula(
      "ω̇ = −3μg/r   ⟹   it rests after ωr/(3μg) = @ s",
      R"(\dot\omega = -\frac{3\mu g}{r} \quad\Rightarrow\quad t = \frac{\omega r}{3\mu g} = @\ \mathrm{s})",
      spin * half_diagonal / (3 * a));
  page.choose(
      {.ask = say("The flat book slides off at @ m/s, once without spin and once spinning at @ rad/s. Which gets "
                  "farther?",
                  setting.speed, Value(spin, 4)),
       .options =
           {{"the one that does not spin",
             "The friction of each corner is shared between slide and spin, so less of it brakes the slide."},
            {"the one that spins",
             say(R"(@ m instead of @ m. The friction of each corner has a fixed length, and part
                                       of it now acts against the spin.)",
                 spinning.distance, straight.distance)},
            {"both get equally far",
             "They would, if slide and spin each had a friction of their own, as axes have in a pyramid."}},
       .answer = spinning.distance > straight.distance ? 1 : 0,
       .hints = {"Against what does the friction of each corner act?",
                 "Its length is μλ; its direction is against the slip v + ω × r of that corner.",
                 "With a spin, the friction of the corners is not parallel."}});
  constexpr int sweeps = 10;
  const double swept = off_its_place(GaussSeidel{.sweeps = sweeps}, setting.h),
               newton = off_its_place(SemismoothNewton{}, setting.h);
  const Quantity with_sweeps("swept", swept, "m"),
      with_newton("heavy cube off its place, by Newton's method", newton, "m");
  page.text(
      R"(Boxes also collide with boxes. Take the heavy box on a light one (lesson 5, step 7b) as cubes of @ kg on 1 kg:
      with @ warm sweeps a step the upper one @. @ (`SemismoothNewton` makes each row and its bound one
      equation; it is for contacts on which sweeps stall.))",
      heavy, sweeps,
      swept < 0.5 ? say("is up to @ mm off its place in the eighth second", Value(1000 * swept, 3))
                  : say("has fallen off after @ s", settling),
      page.verdict({{.when = with_newton < with_sweeps,
                     .say = "Newton's method, on all contacts together, keeps it where it was put.",
                     .law = with_newton < 1e-6}}));
  page.measure("straight", straight.distance, "m");
  page.measure("spinning as well", spinning.distance, "m");

  const Condition at_rest{thrown.rests, say("a book at rest within @ s", patience)};
  page.claim("tumbled: overlap beyond the slop at the end", std::max(0.0, thrown.deepest - slop), "m",
             is(0, "β has taken it away", absolute(1e-6)), at_rest);
  page.claim("tumbled: what presses at the end, over the weight", thrown.pressed, "1",
             is(1, "nothing moves", absolute(1e-3)), at_rest);
  page.claim("tumbled: cosine of the upright axis", thrown.flatness, "1",
             is(1, "it lies on a face", absolute(1e-4)), at_rest);

  page.claim("flat and straight: distance", straight.distance, "m",
             is(speed * speed / (2 * a) - speed * setting.h / 2, "v²/2μg − vh/2: half a step short",
                absolute(a * setting.h * setting.h)));
  page.claim("flat, spinning only: time to rest", whirl.time, "s",
             is(spin * half_diagonal / (3 * a), "ωr/(3μg)", absolute(2 * setting.h)));
}

}  // namespace byhand::space
