#include "lessons/02_single_constraint/steps.hpp"

// One bob, one rod, one row: from a velocity that would break the rod to the impulse that saves it, and to what is
// still wrong after ten seconds of that.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::single_constraint;

  tutor::Lesson lesson(tutor::contents().at(1));
  const Setting setting{
      .length = lesson.parameter("length", 2.0, "m", {0.1, 20}, "length of the rod"),
      .mass = lesson.parameter("mass", 3.0, "kg", {0.01, 1000}, "mass of the bob"),
      .h = lesson.parameter("h", 1.0 / 60, "s", {1e-3, 0.05}, "time step"),
      .angle = lesson.parameter("angle", 30.0, "deg", {0, 180}, "where the bob is let go, from straight down"),
      .release = lesson.parameter("release", 90.0, "deg", {5, 170}, "where the long swings start"),
  };
  const auto with = [setting](void (*step)(const Setting&, tutor::Page&)) {
    return [=](tutor::Page& page) { step(setting, page); };
  };

  lesson.step("Gravity first, and the rod objects", with(gravity_first));
  lesson.step("Four numbers and no matrix", with(effective_mass));
  lesson.step("λ: its sign before its size", with(lambda));
  lesson.step("The impulse turns V onto the tangent", with(onto_the_tangent));
  lesson.step("λ/h is the tension", with(tension));
  lesson.step("The tangent leaves the circle", with(off_the_circle));
  lesson.step("Ten seconds beside the exact pendulum", with(ten_seconds));

  lesson.deeper("Of all impulses, the smallest change", with(least_change));
  lesson.deeper("Gravity after the solve, and how it sinks", with(gravity_after));
  lesson.deeper("Why velocity and not position", with(why_velocity));
  lesson.deeper("The same rod with a third number", with(rigid_rod));

  lesson.closing(
      {.now_you_know =
           {"Gravity goes into V first; JV then says how fast the rod would be stretched.",
            "JM⁻¹Jᵀ is the inverse effective mass: a few numbers, never a matrix, and (17) divides by it.",
            "λ is an impulse. It is negative where the rod pulls, and λ/h is the tension for every h.",
            "After (20) JV = 0 to rounding: the push along Jᵀ is the smallest that does it, and does no work.",
            "JV = 0 holds the rate, not the length. The rod grows by (vh)²/2L a step, and energy only falls."},
       .tries = {{"Let go above the pivot: which sign has λ when the rod must push?",
                  "./lessons/run single_constraint --set angle=120"},
                 {"Take a third of the step: drift and lost energy come down with it.",
                  "./lessons/run single_constraint --set h=1/180"},
                 {"A light bob on a long rod: which numbers do not notice?",
                  "./lessons/run single_constraint --set mass=0.1 --set length=10"}},
       .next = R"(Write K, λ, the impulse and the step yourself: `./lessons/run practise 3` to 6.

               One row is solved exactly by one formula. With two rods that share a bob, solving one spoils the
               other: lesson 3, Iterations. The drift you saw is cured in lesson 4, Baumgarte.)"});
  return lesson.run(argc, argv);
}
