#include "lessons/engines/contest.hpp"

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

template <class M>
void run_from_rest(const Contestant<M>& contestant, const Scene<M>& scene, int settling, int frames,
                   const std::function<bool(Scene<M>&)>& begin,
                   const std::function<void(const Scene<M>&, double)>& look) {
  Scene<M> seen = scene;
  const auto world = contestant.build(scene);
  for (int i = 0; i < settling; ++i) run_frame(*world, contestant.setting.steps);
  if (settling > 0) world->read(seen.state());
  if (begin(seen)) world->set_velocities(seen.bodies());
  for (int i = 1; i <= frames; ++i) {
    run_frame(*world, contestant.setting.steps);
    world->read(seen.state());
    look(seen, i * frame);
  }
}

template <class M>
void run(const Contestant<M>& contestant, const Scene<M>& scene, int frames,
         const std::function<void(const Scene<M>&, double)>& look) {
  run_from_rest<M>(
      contestant, scene, 0, frames, [](Scene<M>&) { return false; }, look);
}

template <class M>
std::vector<Seconds> seconds_a_frame(const std::vector<Contestant<M>>& contestants, const Scene<M>& scene,
                                     int frames, int rounds) {
  std::vector<Seconds> all(contestants.size(), {std::numeric_limits<double>::infinity(), 0});
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const auto world = contestants[i].build(scene);
      const double begin = world->seconds();
      for (int j = 0; j < frames; ++j) run_frame(*world, contestants[i].setting.steps);
      const double seconds = (world->seconds() - begin) / frames;
      all[i] = {std::min(all[i].least, seconds), std::max(all[i].most, seconds)};
    }
  return all;
}

Beside at_equal_time(const std::vector<Point>& points, const std::vector<Point>& others) {
  const auto quickest = [&](const auto& counts) {
    double seconds = std::numeric_limits<double>::infinity();
    for (const Point& point : points)
      if (counts(point)) seconds = std::min(seconds, point.seconds.least);
    return seconds;
  };
  const auto as_quick = [&](double time, double error) {
    return std::any_of(others.begin(), others.end(),
                       [=](const Point& other) { return other.seconds.least <= time && other.error <= error; });
  };
  const auto beats = [&](double Seconds::*round) {
    return quickest([&](const Point& point) {
      const double time = point.seconds.*round;
      return as_quick(time, std::numeric_limits<double>::infinity()) &&
             !as_quick(time, equal_errors * point.error);
    });
  };
  const std::pair<Rank, double> ranks[] = {
      {Rank::ahead, beats(&Seconds::most)},
      {Rank::level, beats(&Seconds::least)},
      {Rank::quicker, quickest([&](const Point& point) { return !as_quick(point.seconds.most, INFINITY); })}};
  for (const auto& [rank, seconds] : ranks)
    if (std::isfinite(seconds)) return {rank, seconds};
  return {};
}

#define BYHAND_INSTANTIATE(M)                                                       \
  template struct Contestant<M>;                                                    \
  template Contestant<M> contestant(const Engine&, const Setting&);                 \
  template void run(const Contestant<M>&, const Scene<M>&, int,                     \
                    const std::function<void(const Scene<M>&, double)>&);           \
  template void run_from_rest(const Contestant<M>&, const Scene<M>&, int, int,      \
                              const std::function<bool(Scene<M>&)>&,                \
                              const std::function<void(const Scene<M>&, double)>&); \
  template std::vector<Seconds> seconds_a_frame(const std::vector<Contestant<M>>&, const Scene<M>&, int, int)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::engines
