#include <gtest/gtest.h>

#include "lessons/scenes/boxes.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/advance.hpp"
#include "solver/measure.hpp"

// A cure of drift that a program adds is one struct: the step asks it and knows none by name.
namespace byhand {
namespace own_cure_test {

/// Baumgarte's correction with an integral: b = (β/h) (C + ι ΣC), so that a steady pull leaves no error.
struct WithIntegral {
  double beta = 0.2, share = 0.1;

  template <class M>
  void begin(Stage<M>& stage) const {
    System<M>& system = stage.work.system;
    auto& sum = kept_as<std::vector<double>>(stage.kept);
    sum.resize(system.rows());
    for (int k = 0; k < system.rows(); ++k) {
      sum[k] += system.C[k];
      system.bias[k] += beta / stage.h * (system.C[k] + share * sum[k]);
    }
  }
};
void require_valid(const WithIntegral&) {}

/// Puts a pendulum's bob back onto its circle once it has moved.
struct BackOntoTheCircle {
  double radius;

  template <class M>
  void after_move(Stage<M>& stage) const {
    auto& position = stage.scene.state().pose[1].position;
    position *= radius / position.norm();
  }
};
void require_valid(const BackOntoTheCircle& cure) { require_positive("radius", cure.radius, "m"); }

using M = PlaneParticle;

TEST(OwnCure, ThatBeginsSetsTheBiasAndKeepsWhatItNeeds) {
  using Stepping = VelocitySteppingWith<GaussSeidel, WithIntegral>;
  Simulation<M, Stepping> own{pendulum<M, NormalisedDistance>(1, 2, 3), {.solver = {1}, .drift = {}}};
  Simulation<M> plain{own.scene, {GaussSeidel{1}, Baumgarte{0.2}}};
  double own_error = 0, plain_error = 0;
  for (int i = 0; i < 300; ++i) {
    own.step(1.0 / 60), plain.step(1.0 / 60);
    own_error += position_error(own).max, plain_error += position_error(plain).max;
  }
  EXPECT_LT(own_error, 0.9 * plain_error);
  EXPECT_EQ(std::any_cast<std::vector<double>&>(own.work.cure).size(), 1u);
}

TEST(OwnCure, ThatActsAfterTheMoveCorrectsThePoses) {
  using Stepping = VelocitySteppingWith<RowSolver, BackOntoTheCircle>;
  Simulation<M, Stepping> own{pendulum<M, NormalisedDistance>(1, 2, 3), {.solver = GaussSeidel{1}, .drift = {2}}};
  for (int i = 0; i < 300; ++i) {
    own.step(1.0 / 60);
    EXPECT_NEAR(own.scene.bodies().pose[1].position.norm(), 2, 1e-15);
  }
  own.method.drift.radius = -1;
  EXPECT_THROW(own.step(1.0 / 60), std::invalid_argument);
}

TEST(OwnCure, StandsInAListWithThoseOfTheLibrary) {
  using Listed = VelocitySteppingWith<RowSolver, std::variant<Baumgarte, WithIntegral>>;
  Simulation<PlaneBody, Listed> listed{stack(2), {GaussSeidel{20}, Baumgarte{.slop = 0.001}}};
  Simulation<PlaneBody> library{stack(2), {GaussSeidel{20}, Baumgarte{.slop = 0.001}}};
  for (int i = 0; i < 30; ++i) listed.step(1.0 / 60), library.step(1.0 / 60);
  for (int i = 0; i < library.scene.bodies().size(); ++i)
    EXPECT_EQ(listed.scene.bodies().pose[i].position, library.scene.bodies().pose[i].position);
}

}  // namespace own_cure_test
}  // namespace byhand
