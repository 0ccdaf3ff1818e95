#include "lessons/stage/watched.hpp"

#include <algorithm>
#include <cmath>

namespace byhand::stage {

double Watched::largest_separation() const {
  double largest = 0;
  for (const Sample& sample : samples) largest = std::max(largest, sample.separation);
  return largest;
}

double Watched::energy_change() const {
  double largest = 0;
  for (const Sample& sample : samples)
    largest = std::max(largest, std::abs(sample.energy - samples.front().energy));
  return energy_scale > 0 ? largest / energy_scale : largest;
}

const std::vector<Placement>& Watched::at(double time) const {
  const auto after = std::upper_bound(times.begin(), times.end(), time + 1e-9);
  return instants[static_cast<std::size_t>(after == times.begin() ? 0 : after - times.begin() - 1)];
}

AnyStepping any_stepping(const VelocityStepping& method) {
  AnyStepping any;
  std::visit([&](const auto& solver) { any.solver = solver; }, method.solver);
  any.drift = method.drift;
  any.substeps = method.substeps;
  any.gyroscopic = method.gyroscopic;
  any.bounce_threshold = method.bounce_threshold;
  return any;
}

Watched watch(const SceneFile& file) { return watch(file, any_stepping(file.method)); }

Watched watch(const SceneFile& file, const Method& method) {
  AnyScene scene = std::visit([](const auto& given) { return AnyScene(given); }, file.scene);
  scene.use(method);
  Watched run;
  run.energy_scale = scene.energy_scale();
  const double between = std::max(file.step, file.duration / 600);
  const auto note = [&](bool last) {
    run.samples.push_back({scene.time(), scene.energy(), scene.separation()});
    if (!last && !run.times.empty() && scene.time() < run.times.back() + 0.999 * between) return;
    run.times.push_back(scene.time());
    run.instants.push_back(scene.placements());
  };
  note(false);
  const long long steps = std::max(1LL, std::llround(file.duration / file.step));
  for (long long i = 1; i <= steps && run.stopped.empty(); ++i) {
    try {
      scene.step(file.step);
      note(i == steps);
    } catch (const std::runtime_error& error) {
      run.stopped = error.what();
    }
  }
  run.effort = scene.effort();
  return run;
}

}  // namespace byhand::stage
