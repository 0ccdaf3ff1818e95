#include "lessons/laws/spin.hpp"

#include <fmt/format.h>

#include <cmath>
#include <numbers>

#include "lessons/exact/simple_pendulum.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/numbers.hpp"
#include "lessons/laws/record.hpp"
#include "lessons/scenes/box_on_an_arm.hpp"
#include "lessons/scenes/top.hpp"
#include "solver/step.hpp"

// Law 13. A velocity is straight, and what turns is not. Of a turn θ = ωh about a hinge r away a step makes the
// centre go rθ along the tangent and the body turn by θ: the hinge is off by r √((θ - sinθ)² + (1 - cosθ)²), half
// of rθ² at first. In space ω has to turn too. Near a stable principal axis a free top wobbles with
//
//   Ω = ω √((I_a - I_b)(I_a - I_c)/(I_b I_c))
//
// and an explicit step multiplies what swings so by |1 + iΩh|: the wobble grows as (1 + Ω²h²)^(t/2h), always. The
// spin at which it grows tenfold in a time t stands in for a boundary. The implicit rule keeps it (head of
// gyroscopic.hpp).
//
// Law 15. On a long arm r the two rows of a pin nearly say the same when the arm is aslant: along and across it A
// has 1/m and 1/m + r²/I, so that at 45° both rows have the mean of these on their diagonal, half their difference
// beside it. One by one they leave ρ = (A12/A11)² a sweep, and with q = ρᵏ law 6 holds: β < (1 - q)/q. As a block
// they are solved at once, and what is left is law 1's stretch: each step leaves ½r(ωh)², of which β takes its
// share, C(n+1) = (1 - β) C(n) + ½ r (ω(t)h)².
//
// Derived for this course.
namespace byhand::laws {
namespace {

/// The largest error of the pin in a swing from level, by law 15's recurrence along the exact swing.
double drift_of_a_block(double side, double arm, double beta) {
  const double length = arm + side * side / (6 * arm);  // of the simple pendulum that swings alike
  const SimplePendulum swing(std::numbers::pi / 2, length, 9.81);
  Eigen::Vector2d C(0, 0);
  double worst = 0;
  for (double t = 0; t < swing.period(); t += sixtieth) {
    C = (1 - beta) * C +
        0.5 * arm * square(swing.angular_velocity(t) * sixtieth) * from_straight_down<PlaneBody>(swing.angle(t));
    worst = std::max(worst, C.norm());
  }
  return worst;
}
double measured_drift_of_a_block(double side, double arm, double beta) {
  Simulation<PlaneBody> simulation{box_on_an_arm(side, arm, std::numbers::pi / 2),
                                   {GaussSeidel{}, Baumgarte{beta}}};
  double worst = 0;
  while (simulation.time < 2) {
    simulation.step(sixtieth);
    const auto& pose = simulation.scene.bodies().pose;
    worst = std::max(worst, simulation.scene.all<Pin>()[0].value<double>(pose[0], pose[1]).norm());
  }
  return worst;
}

}  // namespace

double wobble_growth(int axis, double spin, double step, double time, bool implicit) {
  Eigen::Vector3d omega = Eigen::Vector3d::Zero();
  omega[axis] = spin;
  omega[1] = 1e-4 * spin;
  Simulation<SpaceBody> top{free_top({1, 2, 3}, omega), {GaussSeidel{}, NoDriftCure{}}};
  top.method.gyroscopic = implicit ? Gyroscopic::implicit : Gyroscopic::explicit_;
  // In units in which the wobble is a circle, since the two moments across differ.
  const Eigen::Vector3d moments(1, 2, 3);
  const int other = 2 - axis;
  const double ratio = moments[other] * std::abs(moments[axis] - moments[other]) /
                       (moments[1] * std::abs(moments[axis] - moments[1]));
  const auto wobble = [&] {
    const auto& bodies = top.scene.bodies();
    const Eigen::Vector3d now =
        rotate(inverse(bodies.pose[0].rotation), Eigen::Vector3d(bodies.velocity[0].tail<3>()));
    return std::sqrt(square(now[1]) + ratio * square(now[other]));
  };
  const double first = wobble();
  while (top.time < time - 0.5 * step) top.step(step);
  return wobble() / first;
}

double spin_of_tenfold_wobble(int axis, double step, double time) {
  const Eigen::Vector3d I(1, 2, 3);
  const int other = 2 - axis;
  const double per_spin = std::sqrt((I[axis] - I[1]) * (I[axis] - I[other]) / (I[1] * I[other]));
  return std::sqrt(std::pow(10, 2 * step / time) - 1) / (step * per_spin);
}

double hinge_error(double turn, double arm) {
  Simulation<PlaneBody> simulation{hinged_rod(0.8, 2 * arm, 1), {GaussSeidel{}, NoDriftCure{}}};
  const Bodies<PlaneBody>& bodies = simulation.scene.bodies();
  simulation.scene.gravity.setZero();
  const Eigen::Vector2d out = bodies.pose[1].position;
  simulation.scene.set_velocity(1, turn / sixtieth * Eigen::Vector3d(-out.y(), out.x(), 1));
  simulation.step(sixtieth);
  return simulation.scene.all<Pin>()[0].value<double>(bodies.pose[0], bodies.pose[1]).norm();
}

Law spin() {
  Law law{13,
          Family::too_large_a_step,
          "rotation within a step",
          "a step moves points straight on, but those of a rotating body move on circles",
          "hinge error r√((θ − sinθ)² + (1 − cosθ)²); an explicit wobble of rate Ω grows tenfold in t: (1 + "
          "Ω²h²)^(t/2h) = 10",
          {}};
  for (const double turn : {0.01, 0.1, 1.0, 3.0})
    law.boundaries.push_back({"error of the hinge", "m", fmt::format("{} rad a step, 1 m from the centre", turn),
                              std::hypot(turn - std::sin(turn), 1 - std::cos(turn)), 1e-6,
                              [=] { return hinge_error(turn, 1); }});
  for (const int axis : {0, 2})
    for (const auto& [rate, time] : {std::pair{60, 10}, {240, 10}, {60, 2}})
      law.boundaries.push_back(
          bisected({"spin",
                    "rad/s",
                    fmt::format("about the {} axis, {} Hz, {} s", axis == 0 ? "longest" : "shortest", rate, time),
                    spin_of_tenfold_wobble(axis, 1.0 / rate, time),
                    0.02,
                    {},
                    [axis = axis, rate = rate, time = time](double speed) {
                      return wobble_growth(axis, speed, 1.0 / rate, time) < 10;
                    }}));
  return law;
}

double left_by_a_sweep(const LongArm& box) {
  const double across = 6 * square(box.arm / box.side);  // r²/I of 1 kg
  return square(0.5 * across / (1 + 0.5 * across));
}

Outcome run(const LongArm& box) {
  const GaussSeidel solver{.sweeps = box.sweeps,
                           .block_solve = box.block ? BlockSolve::whole : BlockSolve::row_by_row};
  Simulation<PlaneBody> simulation{box_on_an_arm(box.side, box.arm, 0.25 * std::numbers::pi),
                                   {solver, Baumgarte{box.beta}}};
  simulation.scene.gravity.setZero();
  const double size = 1e-7;
  const auto& pose = simulation.scene.bodies().pose;
  simulation.scene.set_position(1, pose[1].position + size * Eigen::Vector2d::UnitX());
  Record record(size, 0.5 * box.arm);
  for (int i = 0; i < 6000; ++i) {
    simulation.step(sixtieth);
    if (!record.note(simulation.scene.all<Pin>()[0].value<double>(pose[0], pose[1])[0])) break;
  }
  return record.outcome();
}

Law block_or_rows() {
  Law law{15,
          Family::too_few_iterations,
          "block or rows",
          "rows that are nearly dependent have to be solved as one block",
          "row by row β < (1 − q)/q as in law 6, q = (A₁₂/A₁₁)²ᵏ; as a block β < 2",
          {}};
  const auto add = [&](std::string setting, const LongArm& box, double limit) {
    law.boundaries.push_back(
        bisected({"β", "", std::move(setting), limit, 0.02, {}, settles(box, &LongArm::beta, run)}));
  };
  for (const auto& [side, sweeps] : {std::pair{0.1, 10}, {0.1, 30}, {0.3, 1}, {0.3, 4}}) {
    const LongArm box{.side = side, .sweeps = sweeps};
    add(fmt::format("side {} m, row by row, {}", side, counted(sweeps, "sweep")), box,
        largest_beta(std::pow(left_by_a_sweep(box), sweeps)));
  }
  add("side 0.1 m, as a block, 1 sweep", {.sweeps = 1, .block = true}, 2);
  for (const double beta : {0.1, 0.2, 0.5})
    law.boundaries.push_back({"drift", "m", fmt::format("side 0.1 m, as a block, β {}", beta),
                              drift_of_a_block(0.1, 1, beta), 0.05,
                              [=] { return measured_drift_of_a_block(0.1, 1, beta); }});
  return law;
}

}  // namespace byhand::laws
