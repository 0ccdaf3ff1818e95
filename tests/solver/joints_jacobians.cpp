#include <gtest/gtest.h>

#include "solver/constraints/hinge.hpp"
#include "solver/constraints/limit.hpp"
#include "solver/constraints/motor.hpp"
#include "solver/constraints/slider.hpp"
#include "solver/constraints/weld.hpp"
#include "tests/solver/compiled.hpp"
#include "tests/solver/dual.hpp"
#include "tests/solver/random.hpp"

// J of every joint, derived by hand, against its C by dual numbers: at any pose, far from where the joint holds.
namespace joints_jacobians_test {

using namespace byhand;
constexpr int draws = 200;

template <class M>
Turn<M> random_turn(Random& random, const Bodies<M>& bodies) {
  if constexpr (M::angular == 1)
    return turn<M>(bodies, 0, 1);
  else
    return turn<M>(bodies, 0, 1, random.direction<M>());
}

void expect_same_columns(const Dense& J, const Dense& gradient, double tolerance) {
  for (int i = 0; i < J.columns(); ++i)
    EXPECT_LE(difference(gradient.column(i), J.column(i)), tolerance) << "number " << i;
}

/// Moves each of the 2 dof numbers of the pair by itself.
template <class Kind, class M>
void expect_gradient(const Kind& kind, const Pair<M>& pair, double tolerance) {
  expect_same_columns(kind.jacobian(pair.pose1, pair.pose2).matrix,
                      gradient_by_duals(kind, pair.pose1, pair.pose2), tolerance);
}

TEST_IN_BOTH_BODIES(Joints, JacobiansAreGradientsOfCAtEveryPose, draws) {
  const auto made = random_pair<M>(random), moved = random_pair<M>(random);
  const Bodies<M> bodies = made.bodies();
  const Linear<M> point = random.vector<M::linear>(2), axis = random.direction<M>();
  expect_gradient(weld<M>(bodies, 0, 1, point), moved, 1e-12);
  expect_gradient(slider<M>(bodies, 0, 1, point, axis), moved, 1e-12);
  expect_gradient(motor<M>(slide<M>(bodies, 0, 1, point, axis), 1, 1), moved, 1e-12);
  if constexpr (M::angular == 3) {
    expect_gradient(hinge<M>(bodies, 0, 1, point, axis), moved, 1e-12);
    // Where the axes are parallel an angle has no gradient: 1/sin ψ tells how near.
    const auto cone = at_most<M>(1, swing<M>(bodies, 0, 1, axis));
    const double psi = 1 - cone.template value<double>(moved.pose1, moved.pose2)[0];
    expect_gradient(cone, moved, 1e-13 / std::sin(psi));
  }
  // Near half a turn across its axis an angle has no gradient: 1/(w² + z²) tells how near.
  const auto spin = motor<M>(random_turn(random, bodies), 1, 1);
  const double steep = Dense(spin.jacobian(moved.pose1, moved.pose2).matrix).largest();
  expect_gradient(spin, moved, 1e-13 * std::max(10.0, steep * steep));
}

}  // namespace joints_jacobians_test
