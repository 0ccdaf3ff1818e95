#include "lessons/engines/contest.hpp"

#include <algorithm>
#include <optional>

namespace byhand::engines {
namespace {

template <class M>
const auto& builder(const Engine& engine) {
  if constexpr (M::linear == 2)
    return engine.in_plane;
  else
    return engine.in_space;
}

template <class M>
void run_frame(World<M>& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step(frame / steps);
}

}  // namespace

template <class M>
std::string Contestant<M>::words() const {
  if (setting.steps == 1) return setting.knobs.words();
  return (setting.knobs.turned().empty() ? std::string() : setting.knobs.words() + ", ") +
         std::to_string(setting.steps) + " steps a frame";
}

template <class M>
Contestant<M> contestant(const Engine& engine, const Setting& setting) {
  return {engine.name, setting, [build = builder<M>(engine), knobs = setting.knobs](const Scene<M>& scene) {
            return build(scene, knobs);
          }};
}

namespace {

/// From the start on, the scene as the engine has it.
template <class M>
Scene<M> begun(const Start<M>& start, World<M>& world, int steps, const Scene<M>& scene) {
  Scene<M> seen = scene;
  for (int i = 0; i < start.settling; ++i) run_frame(world, steps);
  if (start.settling > 0) world.read(seen.state());
  if (start.begin(seen)) world.set_velocities(seen.bodies());
  return seen;
}

}  // namespace

template <class M>
void run_while(const Start<M>& start, const Contestant<M>& contestant, const Scene<M>& scene, int frames,
               const std::function<bool(const Scene<M>&, double)>& look) {
  const auto world = contestant.build(scene);
  Scene<M> seen = begun(start, *world, contestant.setting.steps, scene);
  for (int i = 1; i <= frames; ++i) {
    run_frame(*world, contestant.setting.steps);
    world->read(seen.state());
    if (!look(seen, i * frame)) return;
  }
}

template <class M>
void run_from(const Start<M>& start, const Contestant<M>& contestant, const Scene<M>& scene, int frames,
              const std::function<void(const Scene<M>&, double)>& look) {
  run_while<M>(start, contestant, scene, frames, [&](const Scene<M>& seen, double time) {
    look(seen, time);
    return true;
  });
}

template <class M>
void run(const Contestant<M>& contestant, const Scene<M>& scene, int frames,
         const std::function<void(const Scene<M>&, double)>& look) {
  run_from<M>({}, contestant, scene, frames, look);
}

template <class M>
std::vector<Seconds> seconds_a_frame(const Start<M>& start, const std::vector<Contestant<M>>& contestants,
                                     const Scene<M>& scene, int frames, int rounds) {
  std::vector<Seconds> all(contestants.size(), {std::numeric_limits<double>::infinity(), 0});
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      constexpr double long_enough = 1e-3;  // [s], beside the grain of a clock
      double taken = 0;
      int runs = 0;
      for (; taken < long_enough && runs < 100; ++runs) {
        const auto world = contestants[i].build(scene);
        begun(start, *world, contestants[i].setting.steps, scene);
        const double begin = world->seconds();
        for (int j = 0; j < frames; ++j) run_frame(*world, contestants[i].setting.steps);
        taken += world->seconds() - begin;
      }
      const double seconds = taken / (runs * frames);
      all[i] = {std::min(all[i].least, seconds), std::max(all[i].most, seconds)};
    }
  return all;
}

Beside at_equal_time(const std::vector<Point>& points, const std::vector<Point>& others) {
  const auto seconds = [](const Point& point) { return point.seconds.least; };
  const auto quickest_other = std::ranges::min_element(others, {}, seconds);
  const auto within = [&](double time, double error) {
    return std::ranges::any_of(
        others, [=](const Point& other) { return other.seconds.least <= time && other.error <= error; });
  };
  const auto least = [](const Point& point) { return std::pair(point.error, point.seconds.least); };
  const auto best = [&](const auto& counts) {
    std::vector<Point> found;
    std::ranges::copy_if(points, std::back_inserter(found), counts);
    const auto one = std::ranges::min_element(found, {}, least);
    return one == found.end() ? std::nullopt : std::optional(*one);
  };
  const auto slow = [](const Point& point) { return equal_times * point.seconds.least; };
  const auto beats = [&](const auto& time) {
    return best([&](const Point& point) {
      return !others.empty() &&
             !within(std::max(time(point), quickest_other->seconds.least), equal_errors * point.error);
    });
  };
  const auto quicker = best([&](const Point& point) { return !within(slow(point), INFINITY); });
  if (const auto point = beats(slow)) return {Rank::ahead, *point, quicker};
  if (const auto point = beats(seconds)) return {Rank::level, *point, quicker};
  return {.quicker = quicker};
}

#define BYHAND_INSTANTIATE(M)                                                                       \
  template struct Contestant<M>;                                                                    \
  template Contestant<M> contestant(const Engine&, const Setting&);                                 \
  template void run(const Contestant<M>&, const Scene<M>&, int,                                     \
                    const std::function<void(const Scene<M>&, double)>&);                           \
  template void run_from(const Start<M>&, const Contestant<M>&, const Scene<M>&, int,               \
                         const std::function<void(const Scene<M>&, double)>&);                      \
  template void run_while(const Start<M>&, const Contestant<M>&, const Scene<M>&, int,              \
                          const std::function<bool(const Scene<M>&, double)>&);                     \
  template std::vector<Seconds> seconds_a_frame(const Start<M>&, const std::vector<Contestant<M>>&, \
                                                const Scene<M>&, int, int)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::engines
