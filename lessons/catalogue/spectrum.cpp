#include "lessons/catalogue/spectrum.hpp"

#include <limits>
#include <variant>

#include "lessons/laws/law.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/laws/spectral_radius.hpp"

namespace byhand {
namespace {

using M = PlaneParticle;
constexpr double infinity = std::numeric_limits<double>::infinity();

/// f(simulation) of the chain at rest with any method; `otherwise` where a step has no solution.
template <class T, class F>
T at_rest(const ChainOptions& chain, const Method& method, T otherwise, F&& f) {
  return std::visit(
      [&](const auto& family) {
        try {
          return f(Simulation{rod_chain<M, NormalisedDistance>(chain), family});
        } catch (const std::runtime_error&) {
          return otherwise;
        }
      },
      method);
}

}  // namespace

double spectral_radius(const ChainOptions& chain, const Method& method, double h) {
  return at_rest(chain, method, infinity, [&](auto simulation) {
    for (int i = 0; i < 200; ++i) simulation.step(h);  // a warm start, and the stretch that few iterations leave
    const int n = chain.links;
    const double nudge = 1e-6 * chain.length;
    const auto after = [&](int coordinate, double by) {
      auto nudged = simulation;
      auto& bodies = nudged.scene.state();
      const int body = 1 + coordinate % n;
      (coordinate < n ? bodies.pose[body].position.x() : bodies.velocity[body].x()) += by;
      nudged.step(h);
      Eigen::VectorXd state(2 * n);
      for (int i = 0; i < n; ++i)
        state[i] = bodies.pose[i + 1].position.x(), state[n + i] = bodies.velocity[i + 1].x();
      return state;
    };
    Eigen::MatrixXd step(2 * n, 2 * n);
    for (int k = 0; k < 2 * n; ++k) step.col(k) = (after(k, nudge) - after(k, -nudge)) / (2 * nudge);
    return step.allFinite() ? laws::spectral_radius(step) : infinity;
  });
}

bool stays(const ChainOptions& chain, const Method& method, double h) {
  return at_rest(chain, method, false, [&](auto simulation) {
    const double width = 1e-8 * chain.length;
    const auto& pose = simulation.scene.bodies().pose;
    for (int i = 1; i <= chain.links; ++i)
      simulation.scene.set_position(i, {width * laws::uneven(i), pose[i].position.y()});
    for (int i = 0; i < 1000; ++i) {
      simulation.step(h);
      for (const auto& at : pose)
        if (!(std::abs(at.position.x()) < 1000 * width)) return false;
    }
    return true;
  });
}

double longest_step(const std::function<bool(double)>& stable, double longest) {
  for (double low = 1e-4, high = low; low < longest; low = high) {
    high = std::min(1.1 * low, longest);
    if (!stable(high)) return laws::bisect(stable, low, high, 1e-3);
  }
  return infinity;
}

}  // namespace byhand
