#include <gtest/gtest.h>

#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/rope.hpp"
#include "solver/constraints/spring.hpp"
#include "tests/solver/law_motion.hpp"

namespace law_joints_springs_test {

using namespace byhand;
using M = PlaneParticle;
constexpr double g = 9.81, h = 1.0 / 60;
using Hanging = Simulation<M>;

/// A mass [kg] one metre below a fixed one, on a spring of frequency ω and damping ratio ζ.
Hanging on_spring(double mass, double frequency, double damping_ratio, const RowSolver& solver = Direct{}) {
  Hanging simulation{{}, {solver}};
  auto& scene = simulation.scene;
  scene.add_body(Linear<M>(0, 0), fixed<M>());
  scene.add_body(Linear<M>(0, -1), with_mass<M>(mass));
  Spring<M> spring{{0, 1}, 1};
  spring.elastic = tuned(scene.bodies(), spring, frequency, damping_ratio);
  scene.add(spring);
  return simulation;
}

double stretch(const Hanging& simulation) { return simulation.scene.bodies().pose[1].position.norm() - 1; }

TEST(LawB11, ASoftRowSagsByItsLoadOverItsStiffness) {
  for (const double frequency : {5.0, 60.0, 600.0})
    for (const double mass : {0.1, 3.0}) {
      Hanging simulation = on_spring(mass, frequency, 1);
      run(simulation, 20, h);
      EXPECT_NEAR(stretch(simulation) * frequency * frequency / g, 1, 1e-9) << frequency;
      EXPECT_NEAR(-force(simulation.work, 0), mass * g, 1e-9 * mass * g);
    }
}

TEST(LawB11, ASoftRowIsStableForEveryStiffnessDampingAndStep) {
  for (const double omega_h : {1e-2, 0.1, 0.5, 1.0, 2.0, 10.0, 1e3})
    for (const double damping_ratio : {0.0, 0.1, 1.0, 20.0})
      for (const RowSolver& solver : {RowSolver(Direct{}), RowSolver(GaussSeidel{.sweeps = 1})}) {
        Hanging simulation = on_spring(2, omega_h / h, damping_ratio, solver);
        simulation.scene.gravity.setZero();
        simulation.scene.state().pose[1].position.y() = -1.1;
        const double k = simulation.scene.all<Spring>()[0].elastic.stiffness;
        const auto energy_now = [&] {
          return kinetic_energy(simulation.scene.bodies()) + k * stretch(simulation) * stretch(simulation) / 2;
        };
        double before = energy_now();
        run(simulation, 5, h, [&] {
          ASSERT_LE(energy_now(), before * (1 + 1e-9) + 1e-12) << "ωh " << omega_h << ", ζ " << damping_ratio;
          before = energy_now();
        });
      }
}

// Implicit Euler on v' = -ω²C - 2ζωv, C' = v, which is what the row is when it stands alone.
TEST(LawB11, AloneItIsImplicitEulerOnASpring) {
  const double omega = 20, zeta = 0.3;
  Hanging simulation = on_spring(2, omega, zeta);
  double C = 0, v = 0;
  run(simulation, 2, h, [&] {
    v = (v + h * (g - omega * omega * C)) / (1 + 2 * zeta * omega * h + omega * omega * h * h);
    C += h * v;
    ASSERT_NEAR(stretch(simulation), C, 1e-12);
  });
}

// Whose damping is not given has none: v₁ = (v + hg - hω²C)/(1 + ω²h²).
TEST(LawB11, ASpringIsUndampedUnlessItsDampingIsGiven) {
  Hanging simulation = on_spring(2, 1, 1);
  simulation.scene.change_all<Spring>([](auto& spring) { spring.elastic = {.stiffness = 800}; });
  simulation.scene.state().pose[1].position.y() = -1.3;
  simulation.step(h);
  EXPECT_NEAR(-simulation.scene.bodies().velocity[1].y(), h * (g - 400 * 0.3) / (1 + 400 * h * h), 1e-13);
}

TEST(LawRope, FallsFreelyWhileSlackAndStopsAtItsLength) {
  Hanging simulation{{}, {GaussSeidel{}}};
  auto& scene = simulation.scene;
  scene.add_body(Linear<M>(0, 0), fixed<M>());
  scene.add_body(Linear<M>(0, -0.2), with_mass<M>(2));
  scene.add(Rope<M>{{0, 1}, 1});
  int n = 0;
  bool taut = false;
  run(simulation, 5, h, [&] {
    ++n;
    const double lambda = simulation.impulse(0)[0], y = scene.bodies().pose[1].position.y();
    ASSERT_GE(lambda, 0);
    if (!taut && lambda == 0) {
      ASSERT_NEAR(y, -0.2 - g * h * h * n * (n + 1) / 2, 1e-13);
    } else {
      taut = true;
      ASSERT_NEAR(y, -1, 1e-13);  // it may close its slack within the step, and no more
    }
  });
  EXPECT_TRUE(taut);
  EXPECT_NEAR(force(simulation.work, 0), 2 * g, 1e-12);
}

// A rod would carry the bob on; a rope lets go where the tension m(v²/L + g cosθ) vanishes: from v0² = 4gL below,
// at cosθ = -2/3.
TEST(LawRope, LetsGoWhereItWouldHaveToPush) {
  for (const double step : {1.0 / 240, 1.0 / 960}) {
    Hanging simulation{{}, {Direct{}, Baumgarte{0.2}}};
    auto& scene = simulation.scene;
    scene.add_body(Linear<M>(0, 0), fixed<M>());
    scene.add_body(Linear<M>(0, -1), with_mass<M>(2), Linear<M>(std::sqrt(4 * g), 0));
    scene.add(Rope<M>{{0, 1}, 1});
    double released = 0;
    run(simulation, 1.5, step, [&] {
      if (released == 0 && simulation.work.system.lambda[0] == 0) released = rod_angle(scene, 0, 1);
    });
    EXPECT_NEAR(std::cos(released), -2.0 / 3, 8 * step);
    EXPECT_LT(scene.bodies().pose[1].position.norm(), 1 + 1e-3);
  }
}

}  // namespace law_joints_springs_test
