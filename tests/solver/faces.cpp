#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "solver/constraints/contact_manifold.hpp"
#include "solver/rows/operators.hpp"
#include "solver/rows/prepared.hpp"
#include "solver/step.hpp"
#include "tests/solver/dual.hpp"
#include "tests/solver/random.hpp"

namespace faces_test {

using namespace byhand;
using M = PlaneBody;

ContactManifold<M> random_face(Random& random, const Pair<M>& pair) {
  ContactManifold<M> face;
  face.at = pair.at;
  face.second = random.arms<M>();
  face.point = random.uniform(0, 1) < 0.2;
  face.normal = random.direction<M>();
  face.coefficient = random.uniform(0, 1.5);
  return face;
}

TEST(ContactManifold, JacobianIsTheGradientOfItsEndsAndOfItsSlip) {
  Random random;
  for (int i = 0; i < 200; ++i) {
    const auto pair = random_pair<M>(random);
    const auto face = random_face(random, pair);
    EXPECT_LE(
        difference(face.jacobian(pair.pose1, pair.pose2).matrix, gradient_by_duals(face, pair.pose1, pair.pose2)),
        1e-13);
  }
}

TEST(ContactManifold, WithoutASecondEndIsAContactWithItsFriction) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    const auto pair = random_pair<M>(random);
    auto face = random_face(random, pair);
    face.point = true;
    const auto J = face.jacobian(pair.pose1, pair.pose2);
    const Contact<M> contact{pair.at, face.normal};
    const Friction<M> friction{pair.at, tangents_of<M>(face.normal), 1, 0};
    EXPECT_EQ(difference(Dense(J.matrix).row(0), contact.jacobian(pair.pose1, pair.pose2).matrix), 0);
    EXPECT_TRUE(J.matrix.row(1).isZero(0));
    EXPECT_EQ(difference(Dense(J.matrix).row(2), Dense(friction.jacobian(pair.pose1, pair.pose2).matrix).row(0)),
              0);
  }
}

/// One random face between two moving bodies, with λ that may be anything a bound allows.
struct Face {
  Scene<M> scene;
  Work<M> work;
  Prepared<M> prepared;

  explicit Face(Random& random) {
    const auto pair = random_pair<M>(random);
    scene.add_body(pair.pose1, pair.m1, pair.V1);
    scene.add_body(pair.pose2, pair.m2, pair.V2);
    scene.add(random_face(random, pair));
    lay_out(scene, GaussSeidel{}, work);
    scene.write_rows(work.system, 1.0 / 60);
    set_bias({}, 1.0 / 60, work.system);
    for (int k = 0; k < 2; ++k)
      if (random.uniform(0, 1) < 0.7) work.system.lambda[k] = random.uniform(0, 3);
    const double mu = work.system.upper[0], radius = mu * (work.system.lambda[0] + work.system.lambda[1]);
    work.system.lambda[2] = random.uniform(-radius, radius);
    for (int k = 0; k < 3; ++k) work.system.bias[k] += random.uniform(-1, 1);
  }
  Rows<3> rate() const {
    const auto& block = std::get<block_type<M, 3, Bound::manifold>()>(work.system.blocks)[0];
    Rows<3> rate = dot(block.J, scene.bodies().velocity[0], scene.bodies().velocity[1]);
    for (int k = 0; k < 3; ++k) rate[k] += work.system.bias[k];
    return rate;
  }
};

TEST(ContactManifold, OneSweepLeavesEachEndEitherPressingOrParting) {
  Random random;
  int pressing[3] = {};
  for (int i = 0; i < 2000; ++i) {
    Face face(random);
    const bool point = face.scene.all<ContactManifold>()[0].point;
    // Friction comes after the ends and turns the bodies once more: only without it the ends are as they were
    // left.
    face.work.system.upper[0] = face.work.system.lambda[2] = 0;
    if (i % 2)
      for (int k = 0; k < 2; ++k) face.work.system.gamma[k] = random.uniform(0.1, 1);
    prepare(face.work.system, BlockSolve::whole, 1.0, face.prepared);
    sweep(face.work.system, face.prepared, face.work.system.lambda.data(),
          numbers<M>(face.scene.state().velocity));
    const auto& lambda = face.work.system.lambda;
    EXPECT_EQ(lambda[2], 0);
    Rows<3> rate = face.rate();
    for (int k = 0; k < 2; ++k) rate[k] += face.work.system.gamma[k] * lambda[k];
    int press = 0;
    for (int k = 0; k < (point ? 1 : 2); ++k) {
      EXPECT_GE(lambda[k], 0);
      EXPECT_GE(rate[k], -1e-9);
      EXPECT_NEAR(lambda[k] * rate[k], 0, 1e-9);
      press += lambda[k] > 0;
    }
    ++pressing[press];
  }
  // Of 2,000 draws each case has its share: a rate is of either sign, and each end presses at first in 7 of 10.
  for (int press = 0; press <= 2; ++press) EXPECT_GT(pressing[press], 100) << press << " ends press";
}

TEST(ContactManifold, ManySweepsLeaveComplementaryEndsAndFrictionWithinWhatTheyPress) {
  Random random;
  for (const BlockSolve way : {BlockSolve::whole, BlockSolve::row_by_row}) {
    int stuck = 0, slid = 0, both = 0, one = 0;
    for (int i = 0; i < 500; ++i) {
      Face face(random);
      // Above this friction a point can jam, where Coulomb's law has no answer or several.
      face.work.system.upper[0] = std::min(face.work.system.upper[0], 0.3);
      GaussSeidel solver{.sweeps = 3000, .block_solve = way};
      solver.solve(face.work.system, face.scene.state(), face.prepared, Begin::resume);
      const auto& lambda = face.work.system.lambda;
      const Rows<3> rate = face.rate();
      const double radius = face.work.system.upper[0] * (lambda[0] + lambda[1]);
      const bool point = face.scene.all<ContactManifold>()[0].point;
      for (int k = 0; k < (point ? 1 : 2); ++k) {
        EXPECT_GE(lambda[k], 0);
        EXPECT_NEAR(std::min(lambda[k], rate[k]), 0, 1e-7);
      }
      EXPECT_LE(std::abs(lambda[2]), radius + 1e-12);
      if (radius > 1e-6 && std::abs(lambda[2]) < 0.999 * radius) {
        EXPECT_NEAR(rate[2], 0, 1e-7) << "what holds within its bound sticks";
        ++stuck;
      } else if (radius > 1e-6) {
        EXPECT_LE(rate[2] * lambda[2], 1e-9) << "what slips is rubbed against its slip";
        ++slid;
      }
      both += lambda[0] > 0 && lambda[1] > 0;
      one += (lambda[0] > 0) != (lambda[1] > 0);
    }
    EXPECT_GT(stuck, 10);
    EXPECT_GT(slid, 10);
    EXPECT_GT(both, 10);
    EXPECT_GT(one, 10);
  }
}

// λ >= 0, w = r + A(λ - λ₀) >= 0 and λ·w = 0, also where an end neither presses nor parts, and in any unit.
TEST(ContactManifold, PressingNormalsSolveTheComplementarityProblem) {
  struct Normals {
    double A00, A01, A11;
  };
  for (const auto& [A00, A01, A11] : {Normals{2, 1, 2}, {3, -1, 1}, {3, 2, 2}, {7, 3, 5}, {1, 1, 1}, {3, 0, 0}})
    for (int i = 0; i < 9 * 9 * 16; ++i) {
      const double lambda[] = {0.1 * (i % 4), A11 > 0 ? 0.1 * (i / 4 % 4) : 0};
      const bool alike = A00 == A11 && A01 == A11;  // the two ends are one
      const Rows<3> rate(0.1 * (i / 16 % 9 - 4), A11 == 0 ? 0 : 0.1 * ((alike ? i / 16 % 9 : i / 144) - 4), 0);
      const auto next = pressing_normals(NormalRows(A00, A01, A11, false), rate, lambda);
      const double d0 = next[0] - lambda[0], d1 = next[1] - lambda[1];
      const double w[] = {rate[0] + A00 * d0 + A01 * d1, rate[1] + A01 * d0 + A11 * d1};
      for (int k = 0; k < 2; ++k) {
        EXPECT_GE(next[k], 0);
        EXPECT_NEAR(std::min(next[k], w[k]), 0, 1e-14) << A00 << ' ' << A01 << ' ' << A11 << ", case " << i;
      }
      for (const double unit : {0x1p-50, 0x1p50})
        EXPECT_EQ(pressing_normals(NormalRows(unit * A00, unit * A01, unit * A11, false), unit * rate, lambda),
                  next);
    }
}

}  // namespace faces_test
