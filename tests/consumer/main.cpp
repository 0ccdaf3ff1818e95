#include <cstdio>

#include "solver/byhand.hpp"

using namespace byhand;
using M = PlaneBody;

int main() {
  Scene<M> scene;
  const int ground = scene.add_body({0, 0}, fixed<M>());
  scene.set_shape(ground, HalfSpace<M>{});
  const int post = scene.add_body({0, 3}, fixed<M>());
  const int arm = scene.add_body({1, 3}, box<M>(2, {2, 0.1}));
  const int crate = scene.add_body({5, 0.5}, box<M>(1, {1, 1}));
  scene.set_shape(crate, Box<M>{{1, 1}}, {.friction = 0.6, .restitution = 0.3});
  const auto hinge = scene.add(pin<M>(scene.bodies(), post, arm, {0, 3}));

  Simulation simulation{scene, {ByGraph{}, Baumgarte{.beta = 0.2, .slop = 0.001}}};
  for (int i = 0; i < 600; ++i) simulation.step(1.0 / 60);
  const Linear<M> pull = simulation.reaction(hinge).force;
  std::printf("the hinge pulls the arm with (%.2f, %.2f) N; its largest error is %.1e m\n", pull.x(), pull.y(),
              position_error(simulation.scene).max);
}
