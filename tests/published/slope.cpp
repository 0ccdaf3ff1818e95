#include <fmt/format.h>

#include "lessons/scenes/incline.hpp"
#include "solver/step.hpp"
#include "tests/published/figure.hpp"

namespace byhand::published {
namespace {

constexpr int steps = 120;
constexpr double h = 1.0 / 60, t = steps * h;  // [s]

/// The distance that the box slides from rest [m]. A direct solve, in the plane, errs by rounding, sweeps by at
/// most their tolerance throughout.
template <class M>
Entry slid(const char* who, double friction) {
  Simulation<M> box{box_on_incline<M>(std::atan(0.5), friction)};
  const Linear<M> start = box.scene.bodies().pose[1].position;
  const double time = seconds([&] {
    for (int i = 0; i < steps; ++i) box.step(h);
  });
  const double distance = (box.scene.bodies().pose[1].position - start).norm();
  return {who, distance, "default method", time, M::linear == 2 ? 1e-12 : ConjugateSweeps().tolerance * t};
}

}  // namespace

Figure slope() {
  Figure figure{"Friction on a slope (SCA 2026, figure 1)",
                "A box on a slope of tan θ = 1/2, from rest, 120 steps of 1/60 s.",
                "A Splitting Architecture for Exact Reduced Coulomb Friction, SCA 2026. FBF, Kamino and MuJoCo: "
                "the\n  authors' programs as run by others, github.com/dartsim/dart/pull/3377, PR_REPORT.md.",
                {}};
  const struct {
    double friction, fbf, kamino, mujoco;  // μ, [m]
  } published[] = {
      {0.30, 3.5392831695743054, 3.5392822099580354, 3.5794330878127263},
      {0.40, 1.7698922978656797, 1.7698918846975635, 2.1118162364510042},
      {0.45, 0.8851976117115778, 0.8851977916396285, 1.8350010889171866},
      {0.50, 0.0005018926371855115, 0.0005009063649080669, 0.35929869745695187},
      {0.55, 0.0004281487924409106, 0.0004281487924409106, 1.8135318873257669},
      {0.60, 0.00035627086822120473, 0.0003563241802362017, 1.2524510782262557},
      {0.80, 0.00006883913936487685, 0.00006887912337612457, 0.18109838262409816},
  };
  for (const auto& [friction, fbf, kamino, mujoco] : published) {
    const double a = std::max(0.0, 9.81 * (1 - 2 * friction) / std::sqrt(5));  // g (sin θ - μ cos θ)
    figure.quantities.push_back({fmt::format("μ = {:.2f}, distance [m]", friction),
                                 a * t * (t + h) / 2,
                                 fmt::format("a t (t + h)/2; in continuous time a t²/2 = {:.7g}", a * t * t / 2),
                                 {slid<PlaneBody>("ours, plane", friction),
                                  slid<SpaceBody>("ours, space", friction),
                                  {"FBF", fbf, "space"},
                                  {"Kamino", kamino, "space"},
                                  {"MuJoCo", mujoco, "space"}}});
  }
  return figure;
}

}  // namespace byhand::published
