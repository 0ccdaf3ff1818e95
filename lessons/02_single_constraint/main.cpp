#include "lessons/02_single_constraint/steps.hpp"

// One bob, one rod, one row: from a velocity that would stretch the rod to the impulse that cancels it, and to the
// error that is left after ten seconds.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::single_constraint;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .length = lesson.parameter("length", 2.0, "m", {0.1, 20}, "length of the rod"),
      .mass = lesson.parameter("mass", 3.0, "kg", {0.01, 1000}, "mass of the bob"),
      .h = lesson.parameter("h", 1.0 / 60, "s", {1e-3, 0.05}, "time step"),
      .angle = lesson.parameter("angle", 30.0, "deg", {0, 180},
                                "release angle of the first step (steps 1 to 5 and 7a), from straight down"),
      .release =
          lesson.parameter("release", 90.0, "deg", {5, 170}, "release angle of the swings (steps 5, 7 and 7d)"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("Gravity enters V first", with(gravity_first));
  lesson.hold(in_hand(setting));
  lesson.step("The effective mass", with(effective_mass));
  lesson.step("λ: sign and size", with(lambda));
  lesson.step("What the impulse does to V", with(onto_the_tangent));
  lesson.step("From λ to the tension", with(tension));
  lesson.step("Does JV = 0 keep the rod's length?", with(off_the_circle));
  lesson.step("Ten seconds beside the exact pendulum", with(ten_seconds));

  lesson.deeper("The least change of V", with(least_change));
  lesson.deeper("Gravity added after the solve", with(gravity_after));
  lesson.deeper("Why velocity and not position", with(why_velocity));
  lesson.deeper("A rod that turns", with(rigid_rod));

  lesson.closing(
      {.now_you_know =
           {"Gravity goes into V first; JV then says how fast C would change.",
            "JM⁻¹Jᵀ is the inverse effective mass: a few products, no matrix.",
            "λ|d| is an impulse, negative where the rod pulls; −λ|d|/h is the "
            "tension: the same for every h at release, with an error of order h in the swing.",
            "After (20) JV = 0 to rounding; of all changes of V that get there, this has the least ½ΔV·MΔV (7a).",
            "JV = 0 keeps the rate zero, not the length: C grows by ½h²v² a step, and with b = 0 energy never "
            "rises."},
       .tries = {{"Let go above the fixed point: does the rod pull or push, and what is the sign of λ?",
                  "./lessons/run single_constraint --set angle=120"},
                 {"A third of the step: compare the drift and the lost energy.",
                  "./lessons/run single_constraint --set h=1/180"},
                 {"A light bob on a long rod: which numbers stay the same?",
                  "./lessons/run single_constraint --set mass=0.1 --set length=10"}},
       .next =
           R"(Write JM⁻¹Jᵀ (K in the code), λ, the impulse and the step yourself: `./lessons/run practise 3` to 6.

           One formula solves one row exactly. Where two rods share a bob, solving one row changes the JV of the
           other: lesson 3. Lesson 4 cures the drift that you saw.)"});
  return lesson.run(argc, argv);
}
