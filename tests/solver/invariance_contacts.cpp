#include <gtest/gtest.h>

#include <numeric>

#include "lessons/scenes/dominoes.hpp"
#include "solver/step.hpp"
#include "tests/solver/random.hpp"

// The same scene, its bodies in another order or looked at from elsewhere, moves alike.
namespace invariance_contacts_test {

using namespace byhand;
using M = PlaneBody;
constexpr double h = 1.0 / 60;

/// Dominoes that fall into each other, and a box that slides against them.
Scene<PlaneBody> struck_dominoes() {
  Scene<PlaneBody> scene = dominoes(5, 0.4, 2);
  Pose<M> coming;
  coming.position = {-1, 0.25};
  const int box = add_box(scene, coming, 3, {0.5, 0.5});
  scene.state().velocity[box] = {4, 0, 0};
  return scene;
}

/// The scene with body `order[i]` in the i-th place.
Scene<PlaneBody> reordered(const Scene<PlaneBody>& scene, const std::vector<int>& order) {
  Scene<PlaneBody> result;
  result.gravity = scene.gravity;
  for (const int i : order) {
    result.add_body(scene.bodies().pose[i], scene.bodies().inverse_mass[i], scene.bodies().velocity[i]);
    result.set_shape(result.bodies().size() - 1, scene.colliders().shapes[i], scene.colliders().surfaces[i]);
  }
  return result;
}

/// The scene turned by an angle about the origin, with its gravity, or seen in a mirror at x = 0.
Scene<PlaneBody> turned(Scene<PlaneBody> scene, double angle) {
  const PlaneRotation<double> turn = plane_rotation(angle);
  const auto point = [&](const Linear<M>& p) { return rotate(turn, p); };
  scene.gravity = point(scene.gravity);
  for (auto& pose : scene.state().pose) pose = {point(pose.position), turn * pose.rotation};
  for (auto& V : scene.state().velocity) V.head<2>() = point(V.head<2>());
  return scene;
}
Scene<PlaneBody> mirrored_scene(Scene<PlaneBody> scene) {
  for (auto& pose : scene.state().pose) {
    pose.position.x() *= -1;
    pose.rotation.sin *= -1;
  }
  for (auto& V : scene.state().velocity) {
    V[0] *= -1;
    V[2] *= -1;
  }
  return scene;
}

Scene<PlaneBody> after(const Scene<PlaneBody>& scene, const RowSolver& solver, int steps) {
  Simulation<PlaneBody> simulation{scene, {solver}};
  for (int i = 0; i < steps; ++i) simulation.step(h);
  return simulation.scene;
}

double farthest(const Scene<PlaneBody>& a, const Scene<PlaneBody>& b, const std::vector<int>& order) {
  double largest = 0;
  for (std::size_t i = 0; i < order.size(); ++i)
    largest = std::max({largest, (a.bodies().pose[i].position - b.bodies().pose[order[i]].position).norm(),
                        std::abs(a.bodies().pose[i].rotation.sin - b.bodies().pose[order[i]].rotation.sin)});
  return largest;
}
std::vector<int> as_they_are(const Scene<PlaneBody>& scene) {
  std::vector<int> order(scene.bodies().size());
  std::iota(order.begin(), order.end(), 0);
  return order;
}

// To the last but a few bits as long as touches come at the same steps: an impact is a switch.
struct Way {
  RowSolver solver;
  double error;
};
const Way ways[] = {{Direct{.regularisation = 1e-10, .rounds = 50, .tolerance = 1e-12}, 1e-6},
                    {GaussSeidel{5000}, 1e-6}};

TEST(ContactInvariance, ToTheOrderOfBodies) {
  const Scene<PlaneBody> scene = struck_dominoes();
  std::vector<int> order = as_they_are(scene);
  Random random;
  for (const auto& [solver, error] : ways)
    for (int draw = 0; draw < 4; ++draw) {
      for (std::size_t i = order.size() - 1; i > 0; --i)
        std::swap(order[i], order[random.index(static_cast<int>(i) + 1)]);
      EXPECT_LE(farthest(after(reordered(scene, order), solver, 40), after(scene, solver, 40), order), error);
    }
}

TEST(ContactInvariance, ToATurnOfTheWholeSceneWithItsGravity) {
  const Scene<PlaneBody> scene = struck_dominoes();
  for (const auto& [solver, error] : ways)
    for (const double angle : {0.3, 1.5, -2.0})
      EXPECT_LE(farthest(after(turned(scene, angle), solver, 40), turned(after(scene, solver, 40), angle),
                         as_they_are(scene)),
                error)
          << angle;
}

TEST(ContactInvariance, ToAMirror) {
  const Scene<PlaneBody> scene = struck_dominoes();
  for (const auto& [solver, error] : ways)
    EXPECT_LE(farthest(after(mirrored_scene(scene), solver, 40), mirrored_scene(after(scene, solver, 40)),
                       as_they_are(scene)),
              error);
}

TEST(ContactInvariance, SweepsThatStopEarlyDependOnTheOrderOfBodies) {
  const Scene<PlaneBody> scene = struck_dominoes();
  std::vector<int> order = as_they_are(scene);
  std::reverse(order.begin(), order.end());
  EXPECT_GT(farthest(after(reordered(scene, order), GaussSeidel{2}, 40), after(scene, GaussSeidel{2}, 40), order),
            1e-6);
}

}  // namespace invariance_contacts_test
