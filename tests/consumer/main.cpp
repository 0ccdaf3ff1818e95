#include <cstdio>

#include "lessons/scenes/pendulum.hpp"
#include "solver/measure.hpp"

int main() {
  using namespace byhand;
  Simulation pendulum{hinged_rod(0.5, 2, 3), {Direct{}, Baumgarte{0.2}}};
  for (int i = 0; i < 600; ++i) pendulum.step(1.0 / 60);
  std::printf("largest error of the hinge: %.2e m\n", position_error(pendulum.scene).max);
}
