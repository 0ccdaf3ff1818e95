#include <cmath>

#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneBody;

/// Two boxes on the ground, row by row, from λ = 0: λ_1 of the ground, λ_2 between them; v_1 and v_2 are what
/// gravity and the last step have left, and k sweeps follow. By (17) with K_1 = 1/m and K_2 = 1/m + 1/M.
double sunk(double light, double heavy, double gravity, int sweeps, double h, int steps) {
  double v1 = 0, v2 = 0, fallen = 0;
  for (int i = 0; i < steps; ++i) {
    v1 -= gravity * h, v2 -= gravity * h;
    for (int k = 0; k < sweeps; ++k) {
      v1 = 0;                                                      // the ground's row
      const double change = -(v2 - v1) / (1 / light + 1 / heavy);  // the row between them
      v1 -= change / light, v2 += change / heavy;
    }
    fallen -= h * v2;
  }
  return fallen;
}

Case make() {
  const double m = 1, h = 1.0 / 60, g = 9.81;
  const int sweeps = 10;
  return {.title = "A heavy box sinks through a light one",
          .report =
              "With sequential impulses a heavy box sinks through a light one at mass ratios from about 100 on; "
              "the state stays finite, and nothing warns.",
          .link = "https://github.com/dartsim/dart/issues/3442",
          .law = 4,
          .why =
              "The ground's row sees only the light box, the row between the boxes sees both. A sweep leaves r/(1 "
              "+ r) of the heavy box's speed, and k sweeps from λ = 0 leave q = (r/(1 + r))ᵏ. So the box does not "
              "fall freely, but ends up sinking at gh q/(1 − q).",
          .equation = {"v(n+1) = q (v(n) − gh),  q = (r/(1 + r))ᵏ",
                       R"(v_{n+1} = q\,(v_n - gh), \quad q = \left(\frac{r}{1+r}\right)^k)"},
          .numbers =
              [=](const SceneFile& file) {
                const int steps = 12;
                const double r = 1000, q = std::pow(r / (1 + r), sweeps);
                const Simulation<M> boxes = after<M>(file, steps * h);
                const double found = 1.5 - boxes.scene.bodies().pose[2].position.y();
                double fallen = 0, v = 0;
                for (int i = 0; i < steps; ++i) v = q * (v - g * h), fallen -= h * v;
                return std::vector<Number>{{"how far the heavy box has sunk after 0.2 s, row by row", "m",
                                            sunk(m, r, g, sweeps, h, steps), found, "(17) for two rows", 1e-6},
                                           {"the same by the slow mode alone", "m", fallen, found, "law 4", 0.1}};
              },
          .engines = Question{"how far the heavy box has sunk after 0.2 s", "m", 0.2,
                              [](const Scene<M>& scene) { return 1.5 - scene.bodies().pose[2].position.y(); }},
          .cure =
              "Solve the rows exactly: a column is a tree, which a direct solve with an active set does in one "
              "pass. A warm start alone is no cure: by law 9 it limits the ratio, too.",
          .cured =
              [](SceneFile file) {
                file.method = VelocityStepping{};
                return file;
              },
          .numbers_cured =
              [=](const SceneFile& file) {
                const Simulation<M> boxes = after<M>(file, 2);
                return std::vector<Number>{{"height of the heavy box after 2 s", "m", 1.5,
                                            boxes.scene.bodies().pose[2].position.y(), "C = 0", 1e-3}};
              },
          .takeaway =
              "The sweeps needed grow as the mass ratio. Heavy on light asks for an exact solve, not for more "
              "sweeps; light on heavy costs nothing."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
