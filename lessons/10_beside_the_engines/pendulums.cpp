// Step 2: a bob on a rod and a rod on a pin, against the elliptic integral, and which schemes the engines use.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::beside {
namespace {

using M = PlaneBody;

constexpr double released = 1, length = 1.5, mass = 2;
constexpr int pendulum_frames = 300;

/// The largest error of the angle of body 1, seen from the pivot [rad], and the largest change of the energy, up
/// or down, over the swing's.
struct Swung {
  double error = 0, gained = 0;
};

template <class Exact>
Swung swing(const Contestant<M>& contestant, const Scene<M>& scene, const Exact& exact) {
  Swung swung;
  const double height = mass * gravity * scene.bodies().pose[1].position.norm() * (1 - std::cos(released));
  engines::run<M>(contestant, scene, pendulum_frames, [&](const Scene<M>& seen, double time) {
    const Linear<M> at = seen.bodies().pose[1].position;
    swung.error = larger(swung.error, std::abs(std::atan2(at.x(), -at.y()) - exact.angle(time)));
    swung.gained = farther(swung.gained, (energy(seen) - energy(scene)) / height);
  });
  return swung;
}

/// The largest error of a rod's angle in symplectic Euler: its rate first, then the angle by the new rate.
double error_of_euler_in_the_angle(int steps, const CompoundPendulum& exact) {
  const double h = frame / steps;
  double angle = released, rate = 0, most = 0;
  for (int i = 1; i <= pendulum_frames; ++i) {
    for (int j = 0; j < steps; ++j) {
      rate -= h * 1.5 * gravity / length * std::sin(angle);
      angle += h * rate;
    }
    most = std::max(most, std::abs(angle - exact.angle(i * frame)));
  }
  return most;
}

std::string in_radians(double error) { return in_words(error, Unit::radians); }

/// Engines of one scheme have one error, whoever wrote them.
void by_scheme(Page& page, const Scene<M>& rod, const CompoundPendulum& exact) {
  constexpr int steps = 4;
  std::vector<std::vector<std::string>> rows;
  const double in_the_angle = error_of_euler_in_the_angle(steps, exact);
  rows.push_back({"symplectic Euler in the angle, five lines of code in this lesson", in_radians(in_the_angle)});
  const auto error_of = [&](const Engine& engine, const Knobs& knobs) {
    return swing(engines::contestant<M>(engine, {.knobs = knobs, .steps = steps}), rod, exact).error;
  };
  const double ours = error_of(engines::this_course(), {});
  rows.push_back({"this course: J at the start of the step, Baumgarte with β = 0.2", in_radians(ours)});
  for (const Engine& engine : engines::all_engines()) {
    if (engine.name == "MuJoCo" || engine.name == "Bullet multi-body") {
      const double error = error_of(engine, {});
      rows.push_back({say("@: symplectic Euler in the angle", engine.name), in_radians(error)});
      page.claim(say("@'s error over that of five lines in the angle", engine.name), error / in_the_angle, "1",
                 is(1, "the same scheme", relative(1e-3)));
    } else if (engine.name == "ODE direct") {
      const double error = error_of(engine, {{"ERP", 0.2}});
      rows.push_back({"ODE direct: J at the start of the step, ERP = 0.2", in_radians(error)});
      page.claim("ODE direct's error over this course's", error / ours, "1",
                 is(1, "the same scheme", relative(0.01)));
    }
  }
  page.text(
      R"(Engines that share a scheme share the error of a single joint that is solved to the end. With four steps a frame for these:)");
  page.table({"", "error of the angle"}, rows);
}

}  // namespace

void pendulums(const Setting&, Page& page) {
  const Scene<M> bob = pendulum<M>(released, length, mass), rod = hinged_rod(released, length, mass);
  const SimplePendulum exact_bob(released, length, gravity);
  const CompoundPendulum exact_rod(released, length, mass, gravity);
  const Field<M> with_rods = field_of(bob, Kind::joints, From::everywhere, most_of_a_pendulum),
                 with_pins = field_of(rod, Kind::joints, From::everywhere, most_of_a_pendulum);
  const auto swings = outcomes_of(with_pins, [&](const auto& who) { return swing(who, rod, exact_rod); });
  const auto rods = errors_of(swings, &Swung::error);
  const auto bobs = errors_of(outcomes_of(with_rods, [&](const auto& who) { return swing(who, bob, exact_bob); }),
                              &Swung::error);

  page.text(
      R"(Two pendulums of @ m, let go at @ rad: a bob on a massless rod (a distance joint, where an engine has one),
      and a uniform rod on a pin. Their exact angles are known at any time; the error is the largest difference from
      them in @ s.)",
      length, released, pendulum_frames * frame);
  const auto with_steps = [&](int steps) {
    return swing(engines::contestant<M>(engines::this_course(), {.steps = steps}), rod, exact_rod).error;
  };
  const double once = with_steps(1), four = with_steps(4), ratio = once / four;
  page.predict(
      {.ask =
           R"(This course solves the pin exactly. By what factor is the error of the rod's angle larger with one step a
           frame than with four?)",
       .answer = 4,
       .unit = "1",
       .tolerance = 0.6,
       .wrong = {{1, "No iteration is missing, but the error of a step remains."},
                 {16, "The error goes with h, not with h²."}},
       .hints = {"One joint needs no iterations: what is left is the error of the step.",
                 "The error of symplectic Euler is proportional to the step (lesson 9).",
                 "The step is four times as long."},
       .hinted = 4,
       .right = say("Order 1 makes it about four times: @ rad instead of @ rad is @.", Value(once, 2),
                    Value(four, 2), Value(ratio, 3))});
  page.text("The rod on a pin:");
  tell_three<M>(page, with_pins, rods, Unit::radians);
  compare(page, "pendulum_angle",
          say("The rod on a pin: largest error of its angle in @ s.", pendulum_frames * frame), rods,
          "error of the angle (rad)");
  compare_by_time(
      page, "pendulum_clocked", "Error and time of the rod on a pin. As in lesson 9, down and left is good.", rods,
      [=] {
        return against_time(with_pins, rods, Timed<M>{rod, pendulum_frames}, "error of the angle", Unit::radians);
      });
  by_scheme(page, rod, exact_rod);
  page.text("The bob on a rod:");
  tell_three<M>(page, with_rods, bobs, Unit::radians);
  page.text("The largest change in energy of the pinned rod, up or down, relative to the energy of the swing:");
  std::vector<std::vector<std::string>> rows;
  const auto cell = [](const Swung& swung) {
    return std::isfinite(swung.gained) ? say("@ %", Value(100 * swung.gained, 2)) : std::string("failed");
  };
  for (std::size_t i = 0; i < swings.size(); ++i)
    rows.push_back({swings[i].name, cell(swings[i].by_setting[0]), cell(swings[i].by_setting[1]),
                    cell(swings[i].by_setting[rods[i].best_setting()])});
  std::vector<std::string> head{"", "as shipped", "as its manual advises", "with the least error"};
  if (alone()) {
    head.pop_back();
    for (auto& row : rows) row.pop_back();
  }
  page.table(head, rows);
  page.claim("the bob, this course as advised: error of the angle", bobs.front().advised(), "rad",
             is_at_most(0.05, "elliptic integral"));
  page.claim("the rod, this course: error with four times the steps, over that with one step", four / once, "1",
             is(0.25, "symplectic Euler has order 1", relative(0.2)));
}

}  // namespace byhand::beside
