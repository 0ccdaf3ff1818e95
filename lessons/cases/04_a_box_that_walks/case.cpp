#include <algorithm>
#include <cmath>

#include "lessons/cases/case.hpp"

namespace byhand::cases {
namespace {

using M = PlaneBody;
constexpr int sweeps = 4;

/// The file's box, whose corners are solved in this order.
SceneFile with_first(const SceneFile& file, bool left) {
  if (left) return file;
  SceneFile other = file;
  auto& scene = std::get<Scene<M>>(other.scene);
  const auto contacts = std::get<Scene<M>>(file.scene).all<Contact>();
  const auto slips = std::get<Scene<M>>(file.scene).all<Friction>();
  while (scene.count() > 0) scene.remove(scene.entries().front().id);
  for (const int corner : {1, 0}) {
    Friction<M> slip = slips[static_cast<std::size_t>(corner)];
    slip.contact = scene.add(contacts[static_cast<std::size_t>(corner)]);
    scene.add(slip);
  }
  return other;
}

/// The sideways speed after one step, row by row: (17) for the normal and the friction of each corner, from λ = 0.
/// A box of 1 kg and side 1 m has 1/m + s²/I = 2.5/kg in every row, s = ½.
double speed_by_hand(double h, bool left_first) {
  const double g = 9.81, s = 0.5, inverse_inertia = 6, K = 1 + s * s * inverse_inertia, friction = 0.6;
  double vx = 0, vy = -g * h, spin = 0, normal[2] = {0, 0}, slip[2] = {0, 0};
  for (int k = 0; k < sweeps; ++k)
    for (const int corner : {left_first ? 0 : 1, left_first ? 1 : 0}) {
      const double arm = corner == 0 ? -s : s, before = normal[corner];
      normal[corner] = std::max(0.0, before - (vy + arm * spin) / K);
      vy += normal[corner] - before;
      spin += arm * inverse_inertia * (normal[corner] - before);
      const double bound = friction * normal[corner], old = slip[corner];
      slip[corner] = std::clamp(old - (vx + s * spin) / K, -bound, bound);
      vx += slip[corner] - old;
      spin += s * inverse_inertia * (slip[corner] - old);
    }
  return vx;
}

double speed(const SceneFile& file) { return after<M>(file, file.step).scene.bodies().velocity[1].x(); }
double way(const SceneFile& file) { return after<M>(file, 1).scene.bodies().pose[1].position.x(); }

Case make() {
  return {
      .title = "A box at rest walks, always the same way",
      .report =
          "A cube at rest travels 0.25 m in ten hours, always in the same direction; stacks compress and then "
          "walk away.",
      .link =
          "https://github.com/bulletphysics/bullet3/issues/3049 and "
          "https://github.com/schteppe/cannon.js/issues/348",
      .law = 4,
      .why =
          "A sweep solves the left corner before the right one. What it leaves is not symmetric, although the "
          "scene is, and each step adds the same small push. Seen in a mirror the scene is the same, but the "
          "right corner comes first. So in that order the box walks exactly as far to the other side.",
      .equation = {"x(right first) = −x(left first)", R"(x_{\mathrm{right\ first}} = -x_{\mathrm{left\ first}})"},
      .numbers =
          [](const SceneFile& file) {
            const SceneFile other = with_first(file, false);
            return std::vector<Number>{{"sideways speed after one step", "m/s", speed_by_hand(file.step, true),
                                        speed(file), "(17), four rows", 1e-6},
                                       {"the same, the right corner first", "m/s", speed_by_hand(file.step, false),
                                        speed(other), "(17), four rows", 1e-6},
                                       {"way in 1 s with the right corner first over that with the left", "1", -1,
                                        way(other) / way(file), "mirror", 1e-6}};
          },
      .cure =
          "Sweep until nothing changes, or solve exactly: the answer is symmetric, whatever the order. A face as "
          "one block (a "
          "manifold) is symmetric in each sweep.",
      .cured =
          [](SceneFile file) {
            std::get<GaussSeidel>(file.method.solver).sweeps = 200;
            return file;
          },
      .numbers_cured =
          [](const SceneFile& file) {
            return std::vector<Number>{{"way in 1 s", "m", 0, way(file), "symmetry", 1e-9}};
          },
      .takeaway =
          "A drift that always goes the same way is the order of the rows. Reverse it: if the drift reverses too, "
          "you have found the cause."};
}
const bool told = tell(__FILE__, make);

}  // namespace
}  // namespace byhand::cases
