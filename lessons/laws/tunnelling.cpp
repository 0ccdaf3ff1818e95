#include "lessons/laws/tunnelling.hpp"

#include <fmt/format.h>

#include "lessons/scenes/balls.hpp"
#include "solver/step.hpp"

// Law 16. Contacts are looked for once a step, here without the lookahead |v| h of a scene's margin. A ball of
// radius r is turned back by a wall of thickness d if it is seen before its centre has passed the middle of the
// wall, beyond which the nearest way out is through: from `margin` before they touch. That way is r + margin + d/2
// long. Safe is what goes no further in a step,
//
//   v h <= r + margin + d/2,
//
// and of what goes further the share 1 - (r + margin + d/2)/(v h) is not seen, whatever the solver.
namespace byhand::laws {
namespace {

constexpr double radius = 0.05;

}  // namespace

double share_that_passes(const FlyingBalls& balls, int how_many) {
  using M = PlaneBody;
  int passed = 0;
  for (int i = 0; i < how_many; ++i) {
    Scene<M> scene;
    scene.gravity.setZero();
    scene.set_margin(balls.margin, balls.lookahead);
    scene.set_shape(scene.add_body({0, 0}, fixed<M>()), Box<M>{{balls.wall, 20}});
    const double start =
        -(balls.wall + 4 * radius + balls.margin) - (i + 0.5) / how_many * balls.speed * balls.step;
    scene.set_shape(scene.add_body({start, 0}, ball<M>(1, radius), {balls.speed, 0, 0}), Ball<M>{radius});
    Simulation<M> simulation{std::move(scene), {}};
    const double& x = simulation.scene.bodies().pose[1].position.x();
    const double& v = simulation.scene.bodies().velocity[1].x();
    while (x < 0 && v > 0.5 * balls.speed) simulation.step(balls.step);
    passed += x > 0;
  }
  return static_cast<double>(passed) / how_many;
}

Law tunnelling() {
  Law law{16,
          Family::too_large_a_step,
          "tunnelling",
          "a body that moves farther in one step than a contact can be found may pass through a wall",
          "v h < r + margin + d/2",
          {}};
  for (const FlyingBalls& balls :
       {FlyingBalls{}, {.wall = 0.02}, {.wall = 1}, {.margin = 0.2}, {.step = 1.0 / 240}}) {
    const double seen = radius + balls.margin + 0.5 * balls.wall;
    law.boundaries.push_back(
        bisected({"speed",
                  "m/s",
                  fmt::format("wall {} m, margin {} m, {:.0f} Hz", balls.wall, balls.margin, 1 / balls.step),
                  seen / balls.step,
                  0.02,
                  {},
                  [=](double speed) {
                    FlyingBalls faster = balls;
                    faster.speed = speed;
                    return share_that_passes(faster) == 0;
                  }}));
    for (const double times : {1.5, 4.0})
      if (balls.wall == 0.1 && balls.margin == 0.02)
        law.boundaries.push_back({"share that passes", "",
                                  fmt::format("{} times as fast, {:.0f} Hz", times, 1 / balls.step), 1 - 1 / times,
                                  0.02, [=] {
                                    FlyingBalls faster = balls;
                                    faster.speed = times * seen / balls.step;
                                    return share_that_passes(faster);
                                  }});
  }
  return law;
}

}  // namespace byhand::laws
