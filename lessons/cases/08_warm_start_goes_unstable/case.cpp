#include <cmath>

#include "lessons/cases/case.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/law.hpp"

namespace byhand::cases {
namespace {

using M = PlaneParticle;

/// Whether a small stretch dies out under this β.
bool dies_out(const SceneFile& file, double beta) {
  SceneFile with = file;
  std::get<Baumgarte>(with.method.drift).beta = beta;
  Simulation<M> chain = begin<M>(with);
  const double first = position_error(chain.scene).max;
  double largest = 0;
  for (int i = 0; i < 3000; ++i) {
    chain.step(with.step);
    if (i > 2500) largest = std::max(largest, position_error(chain.scene).max);
    if (!(position_error(chain.scene).max < 1e3 * first)) return false;
  }
  return largest < 0.5 * first;
}

Case make() {
  return {
      .title = "Warm starting goes unstable",
      .report = "A user asks why warm starting, which helps elsewhere, makes some scenes explode.",
      .link = "https://github.com/erincatto/solver2d/issues/8",
      .law = 6,
      .why =
          "A warm start repeats the last λ, and with it the correction that λ contained. k sweeps leave the share "
          "q = ρᵏ of the resulting error, so the correction is applied again and again. The slow mode obeys z³ − "
          "[1 + "
          "2q − (1 − q)β]z² + 3qz − q = 0, whose roots leave the unit circle at β = (1 − q)/q. A chain of N links "
          "has ρ = cos²(π/2N).",
      .equation = {"β < (1 − q)/q,  q = cos²ᵏ(π/2N)",
                   R"(\beta < \frac{1-q}{q}, \quad q = \cos^{2k}\frac{\pi}{2N})"},
      .numbers =
          [](const SceneFile& file) {
            const int sweeps = std::get<GaussSeidel>(file.method.solver).sweeps;
            const double predicted = laws::largest_beta(laws::left_by_sweeps(10, sweeps));
            return std::vector<Number>{{"largest β at which a stretch dies out", "1", predicted,
                                        laws::bisect([&](double beta) { return dies_out(file, beta); },
                                                     predicted / 2, 2 * predicted, 0.005),
                                        "law 6", 0.05}};
          },
      .cure =
          "A β below (1 − q)/q, or a correction that stays out of λ: split impulse is stable for every β up to 2. "
          "With an exact solve q = 0.",
      .cured =
          [](SceneFile file) {
            const double beta = std::get<Baumgarte>(file.method.drift).beta;
            file.method.drift = SplitImpulse{.beta = beta};
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            Simulation<M> chain = begin<M>(file);
            const double first = position_error(chain.scene).max;
            for (int i = 0; i < 3000; ++i) chain.step(file.step);
            return std::vector<Number>{{"stretch that is left, by the first", "1", 0,
                                        position_error(chain.scene).max / first, "split impulse settles", 1e-3}};
          },
      .takeaway =
          "Warm start and Baumgarte limit each other: take more sweeps or a smaller β, or keep the correction out "
          "of λ."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
