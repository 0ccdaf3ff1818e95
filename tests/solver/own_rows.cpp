#include <gtest/gtest.h>

#include "solver/byhand.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/dual.hpp"
#include "tests/solver/random.hpp"

// Kinds of two and of four rows in space, as a program may add: no kind of the library has so many.
namespace own_rows_test {

using namespace byhand;
using M = SpaceBody;
constexpr double g = 9.81, pi = 3.14159265358979323846;

/// Keeps a point of body 2 on a line through a point of body 1, across which its t_k turn with body 1.
///
///   C_k = t_k · (P2 - P1)                                                                        [m]
///   J   = [ -t_k   -(P2 - x1) × t_k   t_k   r2 × t_k ]
struct Rail {
  static constexpr int rows = 2;

  Anchors<M> at;
  Packed<double, 3, 2> across;  // t_k, as columns, in the frame of body 1

  template <class T>
  Rows<2, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    const Linear<M, T> d = at.separation(pose1, pose2);
    Rows<2, T> C;
    for (int k = 0; k < 2; ++k)
      C[k] = rotate(pose1.rotation, Linear<M, T>(across.col(k).template cast<T>())).dot(d);
    return C;
  }
  Jacobian<M, 2> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> r2 = in_world<M, double>(pose2, at.arms.second),
                    to_point = pose2.position + r2 - pose1.position;
    Jacobian<M, 2> J;
    for (int k = 0; k < 2; ++k)
      set_row_along<M>(J, k, rotate(pose1.rotation, Linear<M>(across.col(k))), to_point, r2);
    return J;
  }
};

/// A universal joint: P1 = P2, and an axis of each body at right angles to one of the other.
///
///   C_3 = a1 · a2                                                                                [1]
///   J_3 = [ 0   a1 × a2   0   a2 × a1 ]
struct Universal {
  static constexpr int rows = 4;

  Anchors<M> at;
  Linear<M> axis1, axis2;  // unit vectors, each in the frame of its body

  template <class T>
  Rows<4, T> value(const Pose<M, T>& pose1, const Pose<M, T>& pose2) const {
    Rows<4, T> C;
    C.template head<3>() = at.separation(pose1, pose2);
    C[3] = rotate(pose1.rotation, Linear<M, T>(axis1.cast<T>()))
               .dot(rotate(pose2.rotation, Linear<M, T>(axis2.cast<T>())));
    return C;
  }
  Jacobian<M, 4> jacobian(const Pose<M>& pose1, const Pose<M>& pose2) const {
    const Linear<M> r1 = in_world<M, double>(pose1, at.arms.first),
                    r2 = in_world<M, double>(pose2, at.arms.second), a1 = rotate(pose1.rotation, axis1),
                    a2 = rotate(pose2.rotation, axis2), none = Linear<M>::Zero();
    Jacobian<M, 4> J;
    for (int k = 0; k < 3; ++k) set_row_along<M>(J, k, Linear<M>::Unit(k), r1, r2);
    J.set_row(3, none, a1.cross(a2), none, a2.cross(a1));
    return J;
  }
};

TEST(OwnRows, OfTwoAndOfFourInSpaceHaveTheGradientOfTheirValue) {
  Random random;
  for (int i = 0; i < 100; ++i) {
    const auto pair = random_pair<M>(random);
    const Rail rail{pair.at, tangents_of<M>(random.direction<M>())};
    EXPECT_LE(
        difference(rail.jacobian(pair.pose1, pair.pose2).matrix, gradient_by_duals(rail, pair.pose1, pair.pose2)),
        1e-13);
    const Universal joint{pair.at, random.direction<M>(), random.direction<M>()};
    EXPECT_LE(difference(joint.jacobian(pair.pose1, pair.pose2).matrix,
                         gradient_by_duals(joint, pair.pose1, pair.pose2)),
              1e-13);
  }
}

// Down a rail at 30°, x = ½ g sin 30° t (t + h), and the rail carries m g cos 30°.
TEST(OwnRows, OfTwoInSpaceLetABodySlideDownARail) {
  const double h = 1.0 / 60;
  const Linear<M> along(std::cos(pi / 6), -0.5, 0), out(0.5, std::cos(pi / 6), 0);
  for (const auto& solver : {RowSolver{Direct{}}, RowSolver{GaussSeidel{}}, RowSolver{ByGraph{}}}) {
    Scene<M> scene;
    scene.add_body({0, 0, 0}, fixed<M>());
    scene.add_body({0, 0, 0}, box<M>(2, {0.3, 0.2, 0.1}));
    const auto rail = scene.add(Rail{{0, 1}, tangents_of<M>(along)});
    Simulation simulation{std::move(scene), {solver}};
    for (int i = 0; i < 60; ++i) simulation.step(h);
    EXPECT_LE((simulation.scene.bodies().pose[1].position - g / 4 * (1 + h) * along).norm(), 1e-11);
    EXPECT_LE((simulation.reaction(rail).force - 2 * g * std::cos(pi / 6) * out).norm(), 1e-10);
  }
}

// A shaft turns at 2 rad/s and drives another, bent by 40° from it: Cardan's law has
// tan φ = cos β tan θ for their turns from where the first one's axis is at right angles to both shafts, so that
// ω2/ω1 = cos β / (1 - sin² β sin² θ).
TEST(OwnRows, OfFourInSpaceMakeAUniversalJoint) {
  const double bend = 2 * pi / 9, speed = 2, h = 1.0 / 2000;
  const Linear<M> shaft1 = Linear<M>::UnitX(), shaft2(std::cos(bend), std::sin(bend), 0);
  Scene<M> scene;
  scene.gravity.setZero();
  Velocity<M> turning = Velocity<M>::Zero();
  turning.tail<3>() = speed * shaft1;
  const int ground = scene.add_body({0, 0, 0}, fixed<M>()), first = scene.add_body({0, 0, 0}, fixed<M>(), turning),
            second = scene.add_body({0, 0, 0}, ball<M>(1, 0.3));
  scene.add(hinge<M>(scene.bodies(), ground, second, {0, 0, 0}, shaft2));
  // The cross of the joint: one arm along z, in the first shaft; the other at right angles to it, in the second.
  scene.add(Universal{{first, second}, Linear<M>::UnitZ(), Linear<M>::UnitZ().cross(shaft2)});
  Simulation simulation{std::move(scene), {exact_sweeps(), Baumgarte{.beta = 0.2}}};
  double turned = 0;
  for (int i = 0; i < 3100; ++i) {
    simulation.step(h);
    const double theta = speed * simulation.time, sine = std::sin(bend) * std::sin(theta);
    const double rate = simulation.scene.bodies().velocity[second].tail<3>().dot(shaft2);
    turned += rate * h;
    if (i > 200) {
      ASSERT_NEAR(rate, speed * std::cos(bend) / (1 - sine * sine), 5e-3) << "at " << theta;
    }
  }
  const double theta = speed * simulation.time;
  EXPECT_NEAR(turned, std::atan2(std::cos(bend) * std::sin(theta), std::cos(theta)), 2e-3);
}

// In every model a kind may have as many rows as a body has degrees of freedom.
template <class Model, int K = 1>
constexpr bool has_blocks_of_all_sizes() {
  if constexpr (K > Model::dof)
    return true;
  else
    return block_type<Model, K, Bound::none>() >= 0 && has_blocks_of_all_sizes<Model, K + 1>();
}
static_assert(has_blocks_of_all_sizes<PlaneParticle>() && has_blocks_of_all_sizes<PlaneBody>() &&
              has_blocks_of_all_sizes<SpaceParticle>() && has_blocks_of_all_sizes<SpaceBody>());

}  // namespace own_rows_test
