// Step 2: a bob on a rod and a rod on a pin, against the elliptic integral.

#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"
#include "lessons/exact/compound_pendulum.hpp"
#include "lessons/scenes/pendulum.hpp"

namespace byhand::beside {
namespace {

using M = PlaneBody;

constexpr double released = 1, length = 1.5, mass = 2;
constexpr int pendulum_frames = 300;

/// The largest error of the angle of body 1, seen from the pivot, against exact(time) [rad].
template <class Exact>
double angle_error(const Contestant<M>& contestant, const Scene<M>& scene, const Exact& exact) {
  double most = 0;
  engines::run<M>(contestant, scene, pendulum_frames, [&](const Scene<M>& seen, double time) {
    const Linear<M> at = seen.bodies().pose[1].position;
    most = larger(most, std::abs(std::atan2(at.x(), -at.y()) - exact.angle(time)));
  });
  return most;
}

}  // namespace

void pendulums(const Setting&, Page& page) {
  const Scene<M> bob = pendulum<M>(released, length, mass), rod = hinged_rod(released, length, mass);
  const SimplePendulum exact_bob(released, length, gravity);
  const CompoundPendulum exact_rod(released, length, mass, gravity);
  const auto with_rods = entrants<M>(4, 8, [](const Engine& engine) { return engine.rods; });
  const auto with_pins = entrants<M>(4, 8, [](const Engine&) { return true; });
  const auto bobs = errors_of(with_rods, [&](const auto& who) { return angle_error(who, bob, exact_bob); });
  const auto rods = errors_of(with_pins, [&](const auto& who) { return angle_error(who, rod, exact_rod); });

  page.text(
      R"(Two pendulums of @ m, let go at @ rad: a bob on a massless rod (a distance joint, where an engine has one), and
      a uniform rod on a pin. Their angles are known at any time. The error is the largest difference in @ s.)",
      length, released, pendulum_frames * frame);
  const double once = angle_error(engines::ours<M>(ours_name, best_method(1)), rod, exact_rod),
               ratio = once / rods.front().usual();
  page.predict(
      {.ask =
           R"(This course solves the pin exactly and takes four substeps a frame. With one step a frame, how many
                     times as large is the error of the rod's angle?)",
       .answer = ratio,
       .unit = "1",
       .tolerance = 0.15 * ratio,
       .hints = {"One joint needs no iterations: what is left is the error of the step.",
                 "The error of symplectic Euler is proportional to the step (lesson 9).",
                 "The step is four times as long."},
       .right = say("@ rad instead of @ rad: about four times, for the order is 1.", Value(once, 2),
                    Value(rods.front().usual(), 2))});
  page.figure("pendulum_angle",
              say("The rod on a pin: largest error of its angle in @ s.", pendulum_frames * frame),
              compared(rods, "error of the angle (rad)"));
  // Energy is counted from the lowest position.
  const double swing = mass * gravity * length / 2 * (1 - std::cos(released));
  const auto gained = [&](const Contestant<M>& contestant) {
    double last = 0;
    engines::run<M>(contestant, rod, pendulum_frames, [&](const Scene<M>& seen, double) { last = energy(seen); });
    return (last - energy(rod)) / swing;
  };
  std::vector<std::vector<std::string>> rows;
  for (std::size_t i = 0; i < rods.size(); ++i) {
    const Errors& errors = rods[i];
    const auto same =
        std::find_if(bobs.begin(), bobs.end(), [&](const auto& other) { return other.name == errors.name; });
    const auto cell = [](double error) {
      return std::isfinite(error) ? say("@", Value(error, 2)) : std::string("failed");
    };
    rows.push_back({errors.name, same == bobs.end() ? "no rigid rod" : cell(same->usual()), cell(errors.usual()),
                    cell(errors.least()), reached_with(with_pins.front(), rods.front(), errors.usual()),
                    say("@ %", Value(100 * gained(with_pins[i].settings.front()), 2))});
  }
  page.table({"", "bob, default (rad)", "rod, default (rad)", "rod, 2 to 8 times the work (rad)",
              "this course as exact with", "rod's energy after 5 s, default"},
             rows);
  page.text(
      "The energy is the change over that of the swing: above zero an engine adds energy, below zero it takes "
      "it.");
  page.clocked(
      "pendulum_clocked",
      R"(Error and time of the rod on a pin; along a curve an engine takes more iterations or steps. Times of
               this machine, at the moment of the run.)",
      [=] { return against_time(with_pins, rods, rod, pendulum_frames, "error of the angle (rad)"); });
  const std::string ahead = ahead_of_ours(rods);
  page.text("By default @ less error than this course with four substeps.@",
            ahead.empty() ? "no engine has" : say("of the engines here, these have: @;", ahead),
            ahead.empty() ? "" : " the times beside it say what that costs.");
  page.claim("the bob, this course with four substeps: error of the angle", bobs.front().usual(), "rad",
             is_at_most(0.05, "elliptic integral"));
  const auto& work = bobs.front().by_setting;
  page.claim("the same: error with eight times as many substeps, over that", work.back() / work.front(), "1",
             is(1.0 / 8, "symplectic Euler has order 1", relative(0.2)));
}

}  // namespace byhand::beside
