#include "solver/constraints/distance.hpp"
#include "solver/step.hpp"

// One step of one pendulum, by the cheapest choice: what tests/house/path counts.
using namespace byhand;
using M = PlaneParticle;

int main() {
  Scene<M> scene;
  const int ceiling = scene.add_body({0, 0}, fixed<M>());
  const int bob = scene.add_body({1, 0}, with_mass<M>(1));
  scene.add(Distance<M>{{ceiling, bob}, 1});
  Simulation simulation{scene, {GaussSeidel{1}, NoDriftCure{}}};
  simulation.step(1.0 / 60);
  return simulation.scene.bodies().pose[bob].position.y() < 0 ? 0 : 1;
}
