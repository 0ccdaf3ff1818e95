#include "lessons/engines/contest.hpp"

#include <ctime>

namespace byhand::engines {
namespace {

template <class M>
class Ours : public World<M> {
 public:
  Ours(const Scene<M>& scene, const VelocityStepping& method) : simulation_{scene, method} {}
  void step(double h) override { simulation_.step(h); }
  void read(Bodies<M>& bodies) const override {
    bodies.pose = simulation_.scene.bodies().pose;
    bodies.velocity = simulation_.scene.bodies().velocity;
  }

 private:
  Simulation<M> simulation_;
};

template <class M>
const auto& builder(const Engine& engine) {
  if constexpr (M::linear == 2)
    return engine.in_plane;
  else
    return engine.in_space;
}

/// What all threads of this program have computed, whatever else the machine does [s].
double processor_seconds() {
  timespec now;
  clock_gettime(CLOCK_PROCESS_CPUTIME_ID, &now);
  return static_cast<double>(now.tv_sec) + 1e-9 * static_cast<double>(now.tv_nsec);
}

template <class M>
void run_frame(World<M>& world, int steps) {
  for (int i = 0; i < steps; ++i) world.step(frame / steps);
}

}  // namespace

template <class M>
Contestant<M> ours(std::string name, const VelocityStepping& method, int steps) {
  return {std::move(name), [=](const Scene<M>& scene) { return std::make_unique<Ours<M>>(scene, method); }, steps};
}

template <class M>
Contestant<M> theirs(const Engine& engine, int knob, int steps) {
  return {engine.name, [=, build = builder<M>(engine)](const Scene<M>& scene) { return build(scene, knob); },
          steps};
}

template <class M>
void run(const Contestant<M>& contestant, const Scene<M>& scene, int frames,
         const std::function<void(const Scene<M>&, double)>& look) {
  Scene<M> seen = scene;
  const auto world = contestant.build(scene);
  for (int i = 1; i <= frames; ++i) {
    run_frame(*world, contestant.steps);
    world->read(seen.state());
    look(seen, i * frame);
  }
}

template <class M>
std::vector<double> seconds_a_frame(const std::vector<Contestant<M>>& contestants, const Scene<M>& scene,
                                    int frames, int rounds) {
  std::vector<double> least(contestants.size(), std::numeric_limits<double>::infinity());
  for (int round = 0; round < rounds; ++round)
    for (std::size_t i = 0; i < contestants.size(); ++i) {
      const auto world = contestants[i].build(scene);
      const double begin = processor_seconds();
      for (int j = 0; j < frames; ++j) run_frame(*world, contestants[i].steps);
      least[i] = std::min(least[i], (processor_seconds() - begin) / frames);
    }
  return least;
}

#define BYHAND_INSTANTIATE(M)                                             \
  template Contestant<M> ours(std::string, const VelocityStepping&, int); \
  template Contestant<M> theirs(const Engine&, int, int);                 \
  template void run(const Contestant<M>&, const Scene<M>&, int,           \
                    const std::function<void(const Scene<M>&, double)>&); \
  template std::vector<double> seconds_a_frame(const std::vector<Contestant<M>>&, const Scene<M>&, int, int)
BYHAND_INSTANTIATE(PlaneBody);
BYHAND_INSTANTIATE(SpaceBody);
#undef BYHAND_INSTANTIATE

}  // namespace byhand::engines
