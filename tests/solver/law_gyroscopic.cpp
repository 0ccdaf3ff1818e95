#include <gmock/gmock.h>
#include <gtest/gtest.h>

#include "lessons/exact/free_top.hpp"
#include "lessons/methods/avbd.hpp"
#include "lessons/methods/rattle.hpp"
#include "lessons/methods/xpbd.hpp"
#include "lessons/scenes/top.hpp"
#include "tests/solver/law_motion.hpp"
#include "tests/solver/random.hpp"

namespace law_gyroscopic_test {

using namespace byhand;
using M = SpaceBody;
using Top = Simulation<M>;
constexpr double h = 1.0 / 60;
const Eigen::Vector3d moments(1, 2, 3);

Top top(Gyroscopic gyroscopic, const Eigen::Vector3d& spin) {
  return {free_top(moments, spin), {Direct{}, NoDriftCure{}, 1, gyroscopic}};
}
Eigen::Vector3d spin_of(const Top& top) {  // in the body's axes
  return rotate(inverse(top.scene.bodies().pose[0].rotation),
                Eigen::Vector3d(top.scene.bodies().velocity[0].tail<3>()));
}
/// Near the middle axis.
Eigen::Vector3d wobbling(double speed) { return {0.01 * speed, speed, 0.01 * speed}; }

struct Worst {
  double energy = 0, momentum = 0, size = 0;  // relative changes; of |Iω| alone
};
template <class Method>
Worst after(Simulation<M, Method> top, double time) {
  const double E = kinetic_energy(top.scene.bodies());
  const Eigen::Vector3d L = angular_momentum(top.scene.bodies());
  Worst worst;
  run(top, time, h, [&] {
    const Eigen::Vector3d now = angular_momentum(top.scene.bodies());
    worst.energy = std::max(worst.energy, std::abs(kinetic_energy(top.scene.bodies()) / E - 1));
    worst.momentum = std::max(worst.momentum, (now - L).norm() / L.norm());
    worst.size = std::max(worst.size, std::abs(now.norm() / L.norm() - 1));
  });
  return worst;
}

TEST(LawB13, ImplicitlyEnergyAndMomentumOfAFreeTopStayToRounding) {
  for (const double speed : {1.0, 10.0, 30.0, 60.0}) {  // 60 rad/s is 1 rad a step
    const Worst worst = after(top(Gyroscopic::implicit, wobbling(speed)), 20);
    EXPECT_LT(worst.energy, 3e-14) << speed;
    EXPECT_LT(worst.momentum, 3e-14) << speed;
  }
}

TEST(LawB13, ImplicitlyTheyStayFromAnySpinOfAnyBody) {
  Random random;
  for (int i = 0; i < 50; ++i) {
    Scene<M> scene;
    scene.gravity.setZero();
    Velocity<M> V = Velocity<M>::Zero();
    V.tail<3>() = random.vector<3>(40);
    scene.add_body(random.pose<M>(), random.mass<M>(), V);
    const Worst worst = after(Top{scene, {Direct{}, NoDriftCure{}, 1, Gyroscopic::implicit}}, 5);
    EXPECT_LT(worst.energy, 1e-13) << "draw " << i;
    EXPECT_LT(worst.momentum, 1e-13) << "draw " << i;
  }
}

/// What every method keeps of a free top that turns by so many radians a step about some axis, in 100 steps.
template <class Method>
void expect_kept(const Method& method) {
  Random random;
  for (double angle = 1e-3; angle < 2e3; angle *= 10)
    for (const Eigen::Vector3d& I :
         {moments, Eigen::Vector3d(2, 2, 0.1), Eigen::Vector3d(1e-3, 1, 1), Eigen::Vector3d(5, 5, 9)}) {
      const Eigen::Vector3d spin = angle / h * random.vector<3>(1).normalized();
      const Worst worst = after(Simulation<M, Method>{free_top(I, spin), method}, 100 * h);
      EXPECT_LT(worst.energy, 1e-12) << spin.transpose() << " rad/s, moments " << I.transpose();
      EXPECT_LT(worst.size, 1e-12) << spin.transpose() << " rad/s, moments " << I.transpose();
      EXPECT_LT(worst.momentum, 1e-11) << spin.transpose() << " rad/s, moments " << I.transpose();
    }
}
TEST(LawB13, EveryMethodKeepsThemAtAnySpin) {
  expect_kept(VelocityStepping{});
  expect_kept(Rattle{});
  expect_kept(Xpbd{1, 1});
  expect_kept(Avbd{});
}

// The names of the axes mean nothing, and the rule asks for no moments that a body can have.
TEST(LawB13, ImplicitlyTheyStayWhicheverAxisIsWhich) {
  for (const Eigen::Vector3d& I : {moments, Eigen::Vector3d(1, 0.3, 0.02), Eigen::Vector3d(1, 20, 30)})
    for (const double angle : {0.05, 0.3, 2.0, 30.0}) {
      Eigen::Vector3d first;
      for (int shift = 0; shift < 3; ++shift) {
        const auto shifted = [&](const Eigen::Vector3d& v) {
          return Eigen::Vector3d(v[(3 - shift) % 3], v[(4 - shift) % 3], v[(5 - shift) % 3]);
        };
        Scene<M> scene = free_top(moments, shifted(angle / h * Eigen::Vector3d(0.6, -0.64, 0.48)));
        scene.set_mass(0, {1, shifted(I.cwiseInverse())});
        Top turning{scene, {Direct{}, NoDriftCure{}, 1, Gyroscopic::implicit}};
        const Worst worst = after(turning, 20 * h);
        EXPECT_LT(worst.energy, 1e-13) << angle << ' ' << I.transpose();
        EXPECT_LT(worst.momentum, 1e-12) << angle << ' ' << I.transpose();
        run(turning, 5 * h, h);
        const Eigen::Vector3d spin = spin_of(turning) * h / angle;
        if (shift == 0) first = spin;
        EXPECT_LT((spin - shifted(first)).norm(), 1e-9) << angle << ' ' << I.transpose();
      }
    }
}

// It needs no turn to be followed, so that none is too fast.
TEST(LawB13, ASpinAboutAPrincipalAxisStaysToTheLastBitHoweverFast) {
  for (const double speed : {0.7, 700.0, 7e9})
    for (int axis = 0; axis < 3; ++axis) {
      const Eigen::Vector3d spin = speed * Eigen::Vector3d::Unit(axis);
      Top turning = top(Gyroscopic::implicit, spin);
      turning.step(h);
      EXPECT_EQ(turning.scene.bodies().velocity[0].tail<3>(), spin);
    }
}

// In parts of a step of 1 rad its wobble is as much too fast as in steps of 1 rad, however far the whole step
// turns.
TEST(LawB13, InALongStepATopTurnsOverAsOftenAsInStepsOfARadian) {
  for (const double steps_per_period : {40.0, 8.0, 4.5}) {  // 1, 5 and 9 rad a step
    const double period = FreeTop(moments, wobbling(300)).period(), step = period / steps_per_period;
    Top fast = top(Gyroscopic::implicit, wobbling(300));
    ZeroCrossings crossings(300);
    run(fast, 400 * step, step, [&] { crossings.add(spin_of(fast).y(), fast.time, step); });
    const double apart = (crossings.times.back() - crossings.times.front()) / (crossings.times.size() - 1.0);
    EXPECT_NEAR(apart / (period / 2), 0.9, 0.03) << steps_per_period << " steps a period";
  }
}

TEST(LawB13, ASpinBeyondTheLimitIsRefusedByName) {
  for (const double speed : {1.1e5 / h, 1e12}) {
    Top fast = top(Gyroscopic::implicit, wobbling(speed));
    try {
      fast.step(h);
      ADD_FAILURE() << "nothing was thrown";
    } catch (const NotFinite& error) {  // as an exploded run ends, not bad input
      EXPECT_THAT(error.what(), testing::HasSubstr("a step turns a body by "));
      EXPECT_THAT(error.what(), testing::HasSubstr(" rad, more than 100000"));
    }
    EXPECT_EQ(fast.scene.bodies().velocity[0].tail<3>(), wobbling(speed)) << "the scene stays as it was";
  }
}

TEST(LawB13, ExplicitlyTheTopGainsEnergyUntilItExplodes) {
  const auto gain = [](const Eigen::Vector3d& spin, double time) {
    Top explicit_top = top(Gyroscopic::explicit_, spin);
    const double E = kinetic_energy(explicit_top.scene.bodies());
    double before = E;
    run(explicit_top, time, h, [&] {
      ASSERT_GE(kinetic_energy(explicit_top.scene.bodies()), before * (1 - 1e-14));
      before = kinetic_energy(explicit_top.scene.bodies());
    });
    return before / E - 1;
  };
  EXPECT_GT(gain(wobbling(10), 10), 1);  // it has doubled
  EXPECT_NEAR(gain({0.01, 10, 0}, 20), 8.21, 0.05);
  EXPECT_GT(gain(wobbling(30), 2.4), 1);
  EXPECT_LT(gain(wobbling(1), 10), 0.1);  // slowly turning it is only wrong
}

// The energy that a step of it gains, in the head of gyroscopic.hpp.
TEST(LawB13, AnExplicitStepGainsHalfTheSquareOfItsKick) {
  const Eigen::Vector3d spin(3, -2, 4), kick = moments.cwiseProduct(spin).cross(spin);
  Top explicit_top = top(Gyroscopic::explicit_, spin);
  const double E = kinetic_energy(explicit_top.scene.bodies());
  explicit_top.step(h);
  EXPECT_NEAR(kinetic_energy(explicit_top.scene.bodies()) - E, h * h / 2 * kick.dot(kick.cwiseQuotient(moments)),
              1e-12);
}

TEST(LawA12, LeftOutTheSpinStaysAndTheMomentumTurns) {
  Top left_out = top(Gyroscopic::none, wobbling(10));
  const Eigen::Vector3d omega = left_out.scene.bodies().velocity[0].tail<3>();
  const Eigen::Vector3d L = angular_momentum(left_out.scene.bodies());
  double turned = 0;
  run(left_out, 20, h, [&] {
    ASSERT_EQ(Eigen::Vector3d(left_out.scene.bodies().velocity[0].tail<3>()), omega);
    turned = std::max(turned, (angular_momentum(left_out.scene.bodies()) - L).norm() / L.norm());
  });
  EXPECT_GT(turned, 0.01);
}

// Part C (18): with I left in the body's first axes Iω would be constant, and be wrong by the turn of the body.
TEST(LawA12, OfAnInertiaThatIsNotTurnedTheMomentumDoesNotHold) {
  Top turning = top(Gyroscopic::implicit, wobbling(10));
  const Eigen::Vector3d L = angular_momentum(turning.scene.bodies());
  double unturned = 0;
  run(turning, 2, h, [&] {
    const Eigen::Vector3d omega = turning.scene.bodies().velocity[0].tail<3>();
    unturned = std::max(unturned, (moments.cwiseProduct(omega) - L).norm() / L.norm());
    ASSERT_LT((angular_momentum(turning.scene.bodies()) - L).norm() / L.norm(), 1e-13);
  });
  EXPECT_GT(unturned, 0.1);
}

TEST(LawA12, NearTheMiddleAxisATopTurnsOverEveryHalfPeriod) {
  const auto flips = [](double step) {
    Top flipping = top(Gyroscopic::implicit, wobbling(10));
    ZeroCrossings crossings(10);
    run(flipping, 20, step, [&] { crossings.add(spin_of(flipping).y(), flipping.time, step); });
    return crossings.times;
  };
  const double half_period = FreeTop(moments, wobbling(10)).period() / 2;
  const auto error = [&](double step) {
    const auto times = flips(step);
    EXPECT_GE(times.size(), 9U);
    return (times.back() - times.front()) / (times.size() - 1.0) / half_period - 1;
  };
  const double coarse = error(1.0 / 120), fine = error(1.0 / 240);
  EXPECT_NEAR(fine, 0, 1e-3);
  EXPECT_NEAR(order(coarse, fine), 2, 0.3);
}

TEST(LawA12, SpinConvergesWithOrderTwo) {
  const Eigen::Vector3d spin(3, -2, 4);
  const FreeTop::Spin exact = FreeTop(moments, spin).at(2);
  const auto error = [&](double step) {
    Top turning = top(Gyroscopic::implicit, spin);
    run(turning, 2, step);
    return (spin_of(turning) - exact.value).norm();
  };
  EXPECT_LT(error(1.0 / 480), 1e-2);
  EXPECT_NEAR(order(error(1.0 / 480), error(1.0 / 960)), 2, 0.1);
}

TEST(LawA12, ABallHasNoGyroscopicTermWhateverTheChoice) {
  for (const auto choice : {Gyroscopic::none, Gyroscopic::explicit_, Gyroscopic::implicit}) {
    Simulation<M> rolling{free_top({2, 2, 2}, {3, -5, 4000}), {}};
    rolling.method.gyroscopic = choice;
    const Velocity<M> V = rolling.scene.bodies().velocity[0];
    run(rolling, 5, h);
    EXPECT_EQ(rolling.scene.bodies().velocity[0], V);
  }
}

// Half a turn a step and more: poses alone do not show how fast a body turns.
TEST(Spin, OfAFreeDiscOrBallStaysInMethodsOnPositions) {
  const auto expect_kept = []<class Model>(Model, const auto& method) {
    for (const double speed : {200.0, -2000.0, 60 * 3.14159265358979}) {
      Scene<Model> scene;
      Velocity<Model> V = Velocity<Model>::Zero();
      V[Model::dof - 1] = speed;
      scene.add_body(Linear<Model>(Linear<Model>::Zero()), ball<Model>(1, 0.3), V);
      Simulation simulation{scene, method};
      run(simulation, 10, h);
      EXPECT_NEAR(simulation.scene.bodies().velocity[0][Model::dof - 1] / speed, 1, 1e-12);
    }
  };
  for (const int substeps : {1, 20}) {
    expect_kept(PlaneBody(), Xpbd{substeps, 1});
    expect_kept(SpaceBody(), Xpbd{substeps, 1});
  }
  expect_kept(PlaneBody(), Avbd{});
  expect_kept(SpaceBody(), Avbd{});
}

constexpr double along = 0.08, across = 0.25;  // about the tip [kg m²]
const HeavyTop gyroscope{.mass = 2, .arm = 0.3, .moment_along = along, .moment_across = across, .spin = 60};

struct Precession {
  double rate, lean_error;  // the mean one over four seconds [rad/s], and what its lean changed at most [rad]
};
Precession measured(Gyroscopic choice, double lean, double step) {
  Top top{spinning_top(gyroscope, lean, gyroscope.precession(lean)[0]), {Direct{}, Baumgarte{0.2}}};
  top.method.gyroscopic = choice;
  double azimuth = 0, lean_error = 0;
  Eigen::Vector3d before = top.scene.bodies().pose[1].position;
  run(top, 4, step, [&] {
    const Eigen::Vector3d x = top.scene.bodies().pose[1].position;
    azimuth += std::atan2(before.z() * x.x() - before.x() * x.z(), before.x() * x.x() + before.z() * x.z());
    lean_error = std::max(lean_error, std::abs(std::acos(x.y() / x.norm()) - lean));
    before = x;
  });
  return {azimuth / 4, lean_error};
}

TEST(LawHeavyTop, AGyroscopePrecessesAtItsRateAndKeepsItsLean) {
  for (const double lean : {0.4, 1.2, 1.5707963267948966}) {
    const double exact = gyroscope.precession(lean)[0];
    const Precession coarse = measured(Gyroscopic::implicit, lean, 1.0 / 960),
                     fine = measured(Gyroscopic::implicit, lean, 1.0 / 1920);
    EXPECT_NEAR(fine.rate / exact, 1, 1e-3) << "lean " << lean;
    EXPECT_LT(fine.lean_error, 0.015) << "lean " << lean;
    // What symplectic Euler and a J that is held over the step lose is of first order.
    EXPECT_NEAR(order(coarse.rate - exact, fine.rate - exact), 1, 0.2) << "lean " << lean;
    EXPECT_NEAR(order(coarse.lean_error, fine.lean_error), 1, 0.2) << "lean " << lean;
  }
}

// About its centre it then has the spin of a ball with its moment across.
TEST(LawHeavyTop, WithoutTheGyroscopicTermItPrecessesAsABallWould) {
  HeavyTop ball = gyroscope;
  ball.moment_along = across - gyroscope.mass * gyroscope.arm * gyroscope.arm;
  const double rate = measured(Gyroscopic::none, 1.2, 1.0 / 1920).rate;
  EXPECT_NEAR(rate / ball.precession(1.2)[0], 1, 1e-2);
  EXPECT_GT(rate / gyroscope.precession(1.2)[0], 1.1);
}

}  // namespace law_gyroscopic_test
