#include "lessons/04_baumgarte/steps.hpp"

// Drift, its cure and the limits of the cure: from a rod that grows, by (21) and (22), to the β that a scene can
// bear.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::baumgarte;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .beta = lesson.parameter("beta", 0.2, "1", {0.01, 3}, "share of the error that a step takes away"),
      .h = lesson.parameter("h", 1.0 / 60, "s", {1e-3, 0.05}, "time step"),
      .speed = lesson.parameter("speed", 6.0, "m/s", {0.5, 10}, "of the bob that goes round"),
      .release = lesson.parameter("release", 90.0, "deg", {5, 170}, "where the pendulum starts"),
      .links = lesson.parameter("links", 10, "1", {2, 30}, "links of the chain"),
      .sweeps = lesson.parameter("sweeps", 1, "1", {1, 60}, "sweeps over the chain in a step"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("Drift and its law", with(drift));
  lesson.step("A share β of the error in each step", with(a_share_of_the_error));
  lesson.hold(in_hand(setting));
  lesson.step("Correcting too much", with(both_sides_of_two));
  lesson.step("Read literally, (22) has no 1/h", with(read_literally));
  lesson.step("Dimensionless, yet tied to the frame rate", with(frame_rate));
  lesson.step("What β costs on a pendulum", with(what_it_costs));

  lesson.deeper("Steady stretch of a spinning rod", with(steady_spin));
  lesson.deeper("Warm start, few sweeps and β", with(the_trap));
  lesson.step("When it does not work (reference)", with(when_it_does_not_work));

  lesson.closing(
      {.now_you_know =
           {"JV = 0 follows the tangent: C grows, at first at hv²/2L, and the bob loses energy.",
            R"(JV = −(β/h)C leaves the share 1 − β of an error in each step: no overshoot up to β = 1, overshoot up to
            2, growth beyond.)",
            "As printed, without 1/h, β is a rate in 1/s; with 1/h it is a share per step, with a time constant "
            "of about h/β.",
            R"(On a pendulum the correction adds energy and takes it back; with small steps a swing loses energy for
            every β below 2.)",
            "A steady spin leaves C/L = (ωh)²/(2β).",
            "With a warm start the limit is min((1 − q)/q, 2); with few sweeps that can be far below 0.1."},
       .tries = {{"Just beyond the limit: what do the rod, the charts of step 3 and the claims do?",
                  "./lessons/run baumgarte --set beta=2.1"},
                 {"Double the frame rate but keep h/β: which numbers stay?",
                  "./lessons/run baumgarte --set h=1/120 --set beta=0.1"},
                 {"How many sweeps does the chain of ten links need at this β?",
                  "./lessons/run baumgarte --step 6b --set sweeps=8"}},
       .next =
           R"(Write b yourself: `./lessons/run practise 8`. If a program of yours misbehaves: `./lessons/run symptoms`.

           The correction that shortens a rod also separates bodies that overlap. Contacts come next: rows that
           may only push, and friction, whose bound depends on them.)"});
  return lesson.run(argc, argv);
}
