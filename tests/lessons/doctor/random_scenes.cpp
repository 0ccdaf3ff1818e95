#include "tests/lessons/doctor/random_scenes.hpp"

#include <fmt/format.h>

#include <cmath>
#include <random>

#include "lessons/doctor/doctor.hpp"
#include "lessons/doctor/opening.hpp"
#include "lessons/scenes/box_on_an_arm.hpp"
#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/branches.hpp"
#include "lessons/scenes/bridge.hpp"
#include "lessons/scenes/chain.hpp"
#include "lessons/scenes/four_bar.hpp"
#include "lessons/scenes/ragdoll.hpp"
#include "lessons/scenes/slider_crank.hpp"
#include "lessons/scenes/units.hpp"

namespace byhand::test {
namespace {

class Draw {
 public:
  explicit Draw(int seed) : bits_(static_cast<std::uint64_t>(seed) * 7919 + 13) {
    for (int i = 0; i < 10; ++i) bits_();
  }
  double between(double low, double high) {
    return low + (high - low) * static_cast<double>(bits_() >> 11) * 0x1p-53;
  }
  double ratio(double low, double high) { return low * std::pow(high / low, between(0, 1)); }
  int whole(int low, int high) {
    return low + static_cast<int>(bits_() % static_cast<std::uint64_t>(high - low + 1));
  }
  bool chance(double share) { return between(0, 1) < share; }

 private:
  std::mt19937_64 bits_;
};

template <class M>
Scene<M> random_column(Draw& draw, double heaviest) {
  Scene<M> scene = stack<M>(draw.whole(2, 12), draw.ratio(1, heaviest));
  kick(scene, draw.ratio(1e-3, 0.03));
  return scene;
}

SceneOfAnyModel random_bodies(Draw& draw, std::string& kind) {
  const ChainOptions chain{draw.whole(2, 24), 1, 1, draw.ratio(1, 1000), radians(draw.between(0, 90))};
  switch (draw.whole(0, 12)) {
    case 0: kind = "chain"; return pinned_chain<PlaneBody>(chain);
    case 1: kind = "chain in space"; return pinned_chain<SpaceBody>(chain);
    case 2: kind = "bobs"; return rod_chain<PlaneParticle, NormalisedDistance>(chain);
    case 3: kind = "bobs in space"; return rod_chain<SpaceParticle, NormalisedDistance>(chain);
    case 4: kind = "column"; return random_column<PlaneBody>(draw, 30);
    case 5: kind = "column in space"; return random_column<SpaceBody>(draw, 30);
    case 6: {
      kind = "heavy on light";
      return stack<PlaneBody>(draw.whole(2, 4), draw.ratio(3, 3000));
    }
    case 7: {
      kind = "heavy on light in space";
      return stack<SpaceBody>(draw.whole(2, 4), draw.ratio(3, 3000));
    }
    case 8: kind = "wall"; return pyramid<PlaneBody>(draw.whole(2, 7));
    case 9: kind = "wall in space"; return pyramid<SpaceBody>(draw.whole(2, 4));
    case 10: {
      kind = "ragdoll";
      Scene<PlaneBody> scene;
      add_ground(scene);
      add_ragdoll(scene, {0, draw.between(1.2, 3)});
      return scene;
    }
    case 11: {
      kind = "machine";
      if (draw.chance(0.5)) return four_bar({1, 2, 1, draw.ratio(1, 100), radians(draw.between(10, 80))});
      SliderCrankOptions machine;
      machine.speed = draw.ratio(2, 60);
      machine.piston_mass = draw.ratio(1, 30);
      return slider_crank(machine);
    }
    default: {
      kind = "bridge, tree or arm";
      if (draw.chance(0.4)) return bridge({draw.whole(3, 20)});
      if (draw.chance(0.5)) return pinned_tree<SpaceBody>(draw.whole(2, 4));
      return box_on_an_arm(draw.ratio(0.05, 0.5), 1, radians(draw.between(20, 150)));
    }
  }
}

}  // namespace

SceneFile random_scene(int seed) {
  Draw draw(seed);
  SceneFile file;
  file.scene = random_bodies(draw, file.title);
  file.duration = 4;
  file.method.substeps = draw.chance(0.5) ? 1 : draw.whole(2, 8);
  if (draw.chance(0.7))
    file.method.solver =
        GaussSeidel{.sweeps = static_cast<int>(draw.ratio(1, 60)), .warm_start = draw.chance(0.8)};
  if (draw.chance(0.8))
    file.method.drift = Baumgarte{.beta = draw.between(0.05, 0.6), .slop = 0.001};
  else
    file.method.drift = SplitImpulse{.beta = draw.between(0.05, 0.6), .slop = 0.001};
  return file;
}

namespace {

template <class M>
struct Run {
  std::string stopped = {};
  doctor::Opening worst = {};
  double when = 0;    // it had opened too far [s]; 0: never
  double gained = 0;  // largest energy above that of the beginning [J]
  std::vector<Pose<M>> end = {};
};

double slop_of(const VelocityStepping& method) {
  double slop = 0;
  std::visit(
      [&](const auto& cure) {
        if constexpr (requires { cure.slop; }) slop = cure.slop;
      },
      method.drift);
  return slop;
}

template <class M>
Run<M> run_of(const SceneFile& file, const VelocityStepping& method) {
  Simulation<M> simulation{std::get<Scene<M>>(file.scene), method};
  doctor::Watch<M> watch(simulation.scene, slop_of(method), file.step);
  Run<M> run;
  const double first = energy(simulation.scene);
  const long steps = std::lround(file.duration / file.step);
  for (long i = 0; i < steps; ++i) {
    try {
      simulation.step(file.step);
    } catch (const std::runtime_error& error) {
      run.stopped = error.what();
      break;
    }
    if (watch.look(simulation.scene) && run.when == 0) run.when = simulation.time;
    run.gained = larger(run.gained, energy(simulation.scene) - first);
  }
  run.worst = watch.worst();
  run.end = simulation.scene.bodies().pose;
  return run;
}

}  // namespace

Ending ending_of(const SceneFile& file) {
  double smallest = INFINITY;
  for (const double size : doctor::body_sizes(file))
    if (size > 0) smallest = std::min(smallest, size);
  return std::visit(
      [&]<class M>(const Scene<M>& scene) -> Ending {
        const Run<M> run = run_of<M>(file, file.method);
        if (!run.stopped.empty()) return {true, run.stopped};
        if (run.when > 0)
          return {true, fmt::format("{} by a tenth of a body at {:.2f} s, by {:.2g} at most",
                                    run.worst.joint ? "opens" : "sinks in", run.when, run.worst.share)};
        // Nothing drives what has no motor, so that it cannot gain energy.
        const double lift = doctor::energy_of_a_lift(scene);
        if (run.gained > 0.25 * lift && lift > 0 && !doctor::is_driven(scene))
          return {true, fmt::format("gains {:.2g} J", run.gained)};
        // Bodies that an exact run leaves where they are should be left there.
        VelocityStepping exact;
        exact.substeps = 8;
        const Run<M> reference = run_of<M>(file, exact);
        double moved = 0, apart = 0;
        for (int i = 0; i < scene.bodies().size(); ++i) {
          const auto at = static_cast<std::size_t>(i);
          moved = std::max(moved, (reference.end[at].position - scene.bodies().pose[at].position).norm());
          apart = std::max(apart, (reference.end[at].position - run.end[at].position).norm());
        }
        if (reference.stopped.empty() && moved < 0.25 * smallest && apart > 0.5 * smallest)
          return {true, fmt::format("ends up {:.2g} bodies from its place", apart / smallest)};
        return {};
      },
      file.scene);
}

}  // namespace byhand::test
