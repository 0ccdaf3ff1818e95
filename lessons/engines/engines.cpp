#include "lessons/engines/engine.hpp"

#include <algorithm>
#include <ctime>

#include "lessons/engines/adapters.hpp"

namespace byhand::engines {
namespace {

template <class M>
Asked asked(const Scene<M>& scene) {
  Asked result;
  std::vector<int> path(scene.bodies().size(), 0);
  const auto join = [&](const Anchors<M>& at) {
    path[at.body2] = std::max(path[at.body2], path[at.body1] + 1);
    result.longest_path = std::max(result.longest_path, path[at.body2]);
  };
  for_each_joint(
      scene, [&](const Pin<M>& pin) { ++result.pins, join(pin.at); },
      [&](const Distance<M>& rod) { ++result.rods, join(rod.at); });
  for_each_shape(
      scene,
      [&](int body, const Box<M>&, const Surface&) { result.boxes += moves(scene.bodies().inverse_mass[body]); },
      [](int, const HalfSpace<M>&, const Surface&) {});
  return result;
}

}  // namespace

double processor_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class M>
std::string refusal(const Engine& engine, const Scene<M>& scene) {
  if (M::linear == 3 && engine.home == Home::plane) return "two-dimensional as it is used here";
  return engine.refusal ? engine.refusal(asked(scene)) : std::string();
}
template std::string refusal(const Engine&, const Scene<PlaneBody>&);
template std::string refusal(const Engine&, const Scene<SpaceBody>&);

const std::vector<Engine>& all_engines() {
  static const std::vector<Engine> all = [] {
    std::vector<Engine> found;
    for (const auto add : std::initializer_list<void (*)(std::vector<Engine>&)>{BYHAND_ENGINE_ADAPTERS})
      add(found);
    return found;
  }();
  return all;
}

const std::vector<std::string>& missing() {
  static const std::vector<std::string> names = {BYHAND_MISSING_ENGINES};
  return names;
}

}  // namespace byhand::engines
