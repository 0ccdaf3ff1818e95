#include <gtest/gtest.h>

#include <numbers>

#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/scenes/circle.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

// Laws 1 and 3 where their own boundaries, equation (22) and the claims of lesson 4 do not reach.
namespace law_baumgarte_test {

using namespace byhand;
constexpr double g = 9.81, h = 1.0 / 60, length = 2, mass = 3;

/// A bob at rest in weightlessness, `error` [m] too far from its anchor.
template <class M>
Simulation<M> stretched(double error, const Baumgarte& cure) {
  Simulation<M> simulation{pendulum<M, Distance>(0.4, length, mass), {GaussSeidel{}, cure}};
  simulation.scene.gravity.setZero();
  simulation.scene.state().pose[1].position *= 1 + error / length;
  return simulation;
}
template <class M>
double stretch(const Simulation<M>& simulation) {
  return simulation.scene.bodies().pose[1].position.norm() - length;
}

// ½(d² − L²) is L e to first order, and so is its J: the same β, up to terms in e/L.
TEST_IN_ALL_MODELS(LawB1, TheSquaredFormCorrectsAtNearlyTheSameRate) {
  for (int tenth = 1; tenth <= 20; ++tenth)
    for (const double error : {1e-2, -1e-4}) {
      const double beta = tenth / 10.0;
      auto simulation = stretched<M>(error, {beta});
      simulation.step(h);
      EXPECT_NEAR(stretch(simulation) / error, 1 - beta, beta * std::abs(error) / length) << "beta " << beta;
    }
}

TEST_IN_BOTH_BODIES(LawB1, OfAPinABlockOfRowsLeavesOneMinusBetaOfEach) {
  for (int tenth = 0; tenth <= 25; ++tenth) {
    const double beta = tenth / 10.0;
    Simulation<M> simulation{hinged_rod<M>(0.7, length, mass), {GaussSeidel{}, Baumgarte{beta}}};
    simulation.scene.gravity.setZero();
    const Linear<M> error = 1e-6 * (Linear<M>::Unit(0) - 2 * Linear<M>::Unit(1));
    simulation.scene.state().pose[1].position += error;
    simulation.step(h);
    const auto left = simulation.scene.template all<Pin>()[0].template value<double>(
        simulation.scene.bodies().pose[0], simulation.scene.bodies().pose[1]);
    // The rod also turns by about e/l, whose square is what (21) does not see.
    EXPECT_LT((left - (1 - beta) * error).norm(), 1e-11) << "beta " << beta;
  }
}

// In the steady state a step's tangent leaves the circle by as much as β takes back.
TEST(LawB1, ASpinningRodStaysTooLongByItsTurnSquaredOverTwoBeta) {
  for (const double beta : {0.1, 0.2, 0.3, 0.5, 1.0, 1.5})
    for (const double turn : {0.01, 0.03, 0.1}) {
      const double speed = turn / h * length;
      Simulation<PlaneParticle> simulation{particle_on_a_circle<PlaneParticle>(length, speed, mass),
                                           {GaussSeidel{}, Baumgarte{beta}}};
      run(simulation, 300 * h, h);
      const Eigen::Vector2d before = simulation.scene.bodies().pose[1].position;
      simulation.step(h);
      const Eigen::Vector2d after = simulation.scene.bodies().pose[1].position;
      const double settled = std::asin(cross(before, after)[0] / (before.norm() * after.norm()));
      const double law = laws::stretch_of_a_spinning_rod(settled, beta);
      // Next in the expansion are ½β(C/L)² and ⅓(ωh)⁴ beside (ωh)².
      EXPECT_NEAR((after.norm() / length - 1) / law, 1, settled * settled * (0.5 + 1 / beta))
          << beta << ' ' << turn;
    }
}

/// Mean energy of a pendulum of 90° in each of `periods` swings [J]; heights are taken half way through a step,
/// where the velocities of symplectic Euler belong, or their phase would look like energy.
std::vector<double> mean_energies(const DriftCure& cure, int steps_a_period, int periods) {
  const SimplePendulum exact(std::numbers::pi / 2, length, g);
  Simulation<PlaneParticle> simulation{
      pendulum<PlaneParticle, NormalisedDistance>(std::numbers::pi / 2, length, mass), {GaussSeidel{}, cure}};
  std::vector<double> means(periods, 0.0);
  for (double& mean : means)
    for (int i = 0; i < steps_a_period; ++i) {
      const double before = potential_energy(simulation.scene);
      simulation.step(exact.period() / steps_a_period);
      mean += (kinetic_energy(simulation.scene.bodies()) + (before + potential_energy(simulation.scene)) / 2) /
              steps_a_period;
    }
  return means;
}

TEST(LawB3, APendulumLosesEnergyWhateverItsBeta) {
  for (const int steps : {100, 200, 800}) {
    std::vector<DriftCure> cures{NoDriftCure{}};
    for (const double beta : {0.05, 0.1, 0.2, 0.3, 0.5, 1.0, 1.5, 1.9}) cures.emplace_back(Baumgarte{beta});
    for (const DriftCure& cure : cures) {
      const std::vector<double> means = mean_energies(cure, steps, 4);
      for (int i = 1; i < 4; ++i) EXPECT_LT(means[i], means[i - 1]) << steps << " steps, cure " << cure.index();
    }
  }
}

// The settled stretch h²u/(2β), u = v²/L, lags behind u by h(2 - β)/(2β), so that over a period the tension T does
// work on it: h³(2 - β)/(4β²) ∮ Ṫ u̇ dt. On the pendulum Ṫ u̇ = 6 m g² sin²θ θ̇².
TEST(LawB3, BaumgarteTakesEnergyAsTheCubeOfTheStep) {
  const SimplePendulum exact(std::numbers::pi / 2, length, g);
  double integral = 0;
  const int samples = 1000;
  for (int i = 0; i < samples; ++i) {
    const double time = exact.period() * i / samples;
    integral += 6 * mass * std::pow(g * std::sin(exact.angle(time)) * exact.angular_velocity(time), 2);
  }
  integral *= exact.period() / samples;
  for (const int steps : {1500, 3000})
    for (const double beta : {0.2, 0.3, 0.5, 1.0, 1.5, 1.9}) {
      const std::vector<double> means = mean_energies(Baumgarte{beta}, steps, 2);
      const double law = std::pow(exact.period() / steps, 3) * (2 - beta) / (4 * beta * beta) * integral;
      EXPECT_NEAR((means[0] - means[1]) / law, 1, 0.005) << "beta " << beta << ", " << steps << " steps";
    }
}

}  // namespace law_baumgarte_test
