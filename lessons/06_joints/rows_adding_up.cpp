// Part of step 1: a film of rows that add up to a joint.

#include "lessons/06_joints/rows_adding_up.hpp"

#include <Eigen/LU>

#include "lessons/06_joints/mechanism.hpp"
#include "lessons/pictures/acts.hpp"
#include "lessons/scenes/rod.hpp"
#include "solver/constraints/weld.hpp"

namespace byhand::joints {
namespace {

constexpr double bar_angle = -0.3, seen_seconds = 0.9, motor_speed = 0.8;  // [rad], [s], [rad/s]
constexpr int instants = 90;

/// A bar that flies by with its end at the origin, and the weld that could hold that end to the world.
struct FlyingBar {
  Bodies<PlaneBody> bodies;
  Weld<PlaneBody> joint;
  Velocity<PlaneBody> V;
};

FlyingBar flying_bar(const Setting& setting) {
  const double L = setting.length;
  const PlaneRod bar({0, 0}, L * Point(std::cos(bar_angle), std::sin(bar_angle)), setting.mass);
  Scene<PlaneBody> scene;
  scene.add_body(Pose<PlaneBody>(), fixed<PlaneBody>());
  scene.add_body(bar.pose, bar.mass);
  return {
      scene.bodies(), weld<PlaneBody>(scene.bodies(), 0, 1, Linear<PlaneBody>(0, 0)), {0.5 * L, -0.7 * L, -0.6}};
}

/// The bar with the first rows of the weld: its first velocity, their impulse on it, and its poses from then on.
struct Stage {
  Velocity<PlaneBody> V;
  Eigen::Vector3d lambda = Eigen::Vector3d::Zero();  // (λx, λy, λφ) [N s, N s, N m s]
  std::vector<Pose<PlaneBody>> run = {};
};

/// (17) and (20) for the first K rows as one block. `rate` is what JV shall be.
template <int K>
Rows<K> solve_rows(const FlyingBar& bar, const Pose<PlaneBody>& pose, const Rows<K>& rate,
                   Velocity<PlaneBody>& V) {
  const Pose<PlaneBody>& ground = bar.bodies.pose[0];
  const Jacobian<PlaneBody, K> J{bar.joint.jacobian(ground, pose).matrix.template topRows<K>()};
  const auto W = times_inverse_mass(J, bar.bodies.inverse_mass[0], ground, bar.bodies.inverse_mass[1], pose);
  Velocity<PlaneBody> still = Velocity<PlaneBody>::Zero();
  const Rows<K> lambda = inverse_effective_mass(J, W).inverse() * (rate - dot(J, still, V));
  apply_impulse(W, lambda, still, V);
  return lambda;
}

template <int K>
Stage stage_with(const FlyingBar& bar, double turning = 0) {
  Stage stage{.V = bar.V};
  Rows<K> rate = Rows<K>::Zero();
  if constexpr (K == 3) rate[2] = turning;
  stage.lambda.head<K>() = solve_rows<K>(bar, bar.bodies.pose[1], rate, stage.V);
  const double h = seen_seconds / instants;
  Velocity<PlaneBody> V = stage.V;
  stage.run = {bar.bodies.pose[1]};
  for (int i = 0; i < instants; ++i) {
    stage.run.push_back(moved<PlaneBody, double>(stage.run.back(), V, h));
    const Pose<PlaneBody>& now = stage.run.back();
    Rows<K> held = -bar.joint.value<double>(bar.bodies.pose[0], now).template head<K>() / h;
    if (K == 3) held[K - 1] = turning;
    solve_rows<K>(bar, now, held, V);
  }
  return stage;
}

Stage flying_free(const FlyingBar& bar) {
  Stage stage{.V = bar.V};
  for (int i = 0; i <= instants; ++i)
    stage.run.push_back(moved<PlaneBody, double>(bar.bodies.pose[1], bar.V, i * seen_seconds / instants));
  return stage;
}

struct RowsFilm {
  pictures::Acts acts;
  std::vector<Stage> stages;  // no row, x, x y, x y φ, and φ with a target
  double length, force_scale, turn_scale;

  void draw(Canvas& canvas, double time) const {
    const auto [left, right] = canvas.page().inset(20).panels(0.54, 30, 0.8);
    const std::size_t present = acts.now(time);
    const Stage &now = stages[present], &before = stages[present == 0 ? 0 : present - 1];
    // The rows' impulse comes first, then the bar moves as it may.
    const double share = acts.share(present, time), given = pictures::eased(share / 0.4),
                 moves = present == 0 ? share : pictures::eased((share - 0.4) / 0.6);
    canvas.look(fit(seen(), left, 34));
    const double L = length;
    if (present >= 1) {
      // What the first row allows to the end.
      canvas.line({0, -1.05 * L}, {0, 0.7 * L}, {palette::constraint, 2, Dash::dashed});
      canvas.text({0, 0.7 * L}, "x = 0", {.size = 18, .colour = palette::constraint, .offset = {0, 14}});
    }
    const auto instant = static_cast<std::size_t>(std::lround(moves * instants));
    const Bar first = bar_of(now.run.front(), L), bar = bar_of(now.run[instant], L);
    if (instant > 0) {
      draw_bar(canvas, first, 16, {fade(palette::body, 0.35), {palette::muted, 1.4}});
      std::vector<Point> one, other;
      for (std::size_t i = 0; i <= instant; ++i) {
        one.push_back(bar_of(now.run[i], L).from);
        other.push_back(bar_of(now.run[i], L).to);
      }
      for (const auto& path : {one, other}) canvas.path(path, {palette::velocity, 2, Dash::dotted});
    }
    draw_bar(canvas, bar);
    if (present == 1) draw_sleeve(canvas, bar.from, pi / 2);
    if (present >= 2) canvas.anchor({0, 0}, {1, 0});
    if (present == 3)
      draw_weld(canvas, {0, 0});
    else if (present >= 1)
      canvas.hinge(bar.from);

    // Velocities of both ends at first, as the impulse changes them.
    const Velocity<PlaneBody> V = before.V + given * (now.V - before.V);
    const Point centre = now.run.front().position;
    for (const Point& end : {first.from, first.to}) {
      const Point arm = end - centre, v(V[0] - V[2] * arm.y(), V[1] + V[2] * arm.x());
      if (v.norm() > 1e-6 * L) canvas.arrow(end, end + 0.6 * v, {palette::velocity, 4});
    }
    const Eigen::Vector3d lambda = before.lambda + given * (now.lambda - before.lambda);
    const Point push = force_scale * Point(lambda.head<2>());
    if (push.norm() > 1e-6 * L) canvas.arrow({0, 0}, push, {palette::force, 4.5});
    const double bow = turn_scale * lambda[2];
    if (std::abs(bow) > 1e-6)
      draw_turn(canvas, {0, 0}, bar_angle, bar_angle + bow, 0.3 * L, {palette::force, 4.5});
    acts.draw(canvas, right, time);
  }

  /// All that is drawn at any time.
  Rectangle seen() const {
    std::vector<Point> all{{-0.1 * length, 0.75 * length}, {0, -1.05 * length}};
    for (const Stage& stage : stages) {
      all.push_back(force_scale * Point(stage.lambda.head<2>()));
      for (const Pose<PlaneBody>& pose : stage.run) {
        const Bar bar = bar_of(pose, length);
        all.insert(all.end(), {bar.from, bar.to});
      }
    }
    return bounds(all);
  }
};

}  // namespace

void rows_adding_up(const Setting& setting, Page& page) {
  const FlyingBar bar = flying_bar(setting);
  const std::vector<Stage> stages{flying_free(bar), stage_with<1>(bar), stage_with<2>(bar), stage_with<3>(bar),
                                  stage_with<3>(bar, motor_speed)};
  const double pinned = stages[2].V[2];
  const pictures::Acts acts(
      {{say("V = (@, @) m/s, @ rad/s", Value(bar.V[0], 3), Value(bar.V[1], 3), Value(bar.V[2], 3)),
        "No row. The bar flies by and turns: three motions.", palette::velocity},
       {say("x:  λ_x = @ N·s", Value(stages[1].lambda[0], 3)),
        "One row. The bar's end must not move along x; it slides on the dashed line. Two motions are left.",
        palette::force},
       {say("x, y:  λ = (@, @) N·s", Value(stages[2].lambda[0], 3), Value(stages[2].lambda[1], 3)),
        say("Two rows: a pin. One motion is left, the turn at @ rad/s.", Value(pinned, 3)), palette::force},
       {say("x, y, φ:  λ_φ = @ N·m·s", Value(stages[3].lambda[2], 3)),
        "Three rows: a weld. Its torque (the curved arrow) stops the turn. No motion is left.", palette::force},
       {say("φ to @ rad/s:  λ_φ = @ N·m·s", motor_speed, Value(stages[4].lambda[2], 3)),
        "The third row with a speed as its target: a motor, strong enough here.", palette::force}});
  double largest_push = 0, largest_turn = 0;
  for (const Stage& stage : stages) {
    largest_push = std::max(largest_push, stage.lambda.head<2>().norm());
    largest_turn = std::max(largest_turn, std::abs(stage.lambda[2]));
  }
  page.sequence(
      "rows_adding_up",
      say(R"(A bar of @ kg flies by and is held at one end, by one more row in each act; each act starts from the same
                    place and lasts @ s. Green: the velocity of both ends. Orange: the impulse of the rows on the bar
                    and, curved, its torque.)",
          setting.mass, seen_seconds),
      Seconds{acts.seconds()},
      [film = RowsFilm{acts, stages, setting.length, 0.6 * setting.length / largest_push, 2.2 / largest_turn}](
          Canvas& canvas, double time) { film.draw(canvas, time); });
  const double m = setting.mass, I = 1 / bar.bodies.inverse_mass[1].angular[0];
  const Point r = bar.bodies.pose[1].position;
  page.claim("turn of the bar once its end is pinned", pinned, "rad/s",
             is((I * bar.V[2] + m * (r.x() * bar.V[1] - r.y() * bar.V[0])) / (I + m * r.squaredNorm()),
                "the pin has no torque about itself: Iω + mr × v is kept", relative(1e-12)));
}

}  // namespace byhand::joints
