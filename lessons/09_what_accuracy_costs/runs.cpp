#include "lessons/09_what_accuracy_costs/runs.hpp"

namespace byhand::accuracy {

double error_of(const Problem& problem, const byhand::Setting& setting, Error error) {
  Family alone;
  alone.setting = [&](const Knobs&) { return setting; };
  const byhand::Point point = measure(problem, alone, {});
  return point.has(error) ? point[error] : INFINITY;
}

double period(const Problem& problem, const byhand::Setting& setting) {
  AnyScene scene = problem.start();
  scene.use(setting.method);
  const auto aside = [&] { return scene.placements()[1].position.x(); };
  const double h = frame / setting.steps;
  std::vector<double> passages;
  double before = aside();
  while (passages.size() < 3 && scene.time() < problem.scene().duration) {
    scene.step(h);
    const double now = aside();
    // At the lowest point x has no curvature, so a straight line finds the passage.
    if ((before > 0) != (now > 0)) passages.push_back(scene.time() - h * now / (now - before));
    before = now;
  }
  return passages.size() < 3 ? NAN : passages[2] - passages[0];
}

}  // namespace byhand::accuracy
