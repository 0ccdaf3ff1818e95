#include "lessons/05_contact/steps.hpp"

// Rows that may only push, friction within their bounds, and many contacts together: bounces, cradles, stacks.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::contact;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .h = lesson.parameter("h", 1.0 / 60, "s", {1.0 / 480, 0.05}, "time step"),
      .beta = lesson.parameter("beta", 0.2, "1", {0.05, 1}, "share of an overlap that a step takes away"),
      .width =
          lesson.parameter("width", 0.2, "m", {0.1, 2}, "width of the box that stands on two contacts, 1 m high"),
      .friction = lesson.parameter("friction", 0.4, "1", {0.05, 1}, "coefficient μ"),
      .boxes = lesson.parameter("boxes", 20, "1", {2, 30}, "number of boxes in the stack"),
      .sweeps = lesson.parameter("sweeps", 10, "1", {1, 100}, "sweeps in a step (steps 7 to 7b)"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("A row that may only push", with(push_only));
  lesson.step("A deep contact", with(deep_contact));
  lesson.step("Friction is bounded by the normal", with(friction_row));
  lesson.hold(in_hand(setting));
  lesson.step("A box on a slope", with(sticks_or_slides));
  lesson.step("A bounce", with(bounce));
  lesson.step("Newton's cradle", with(cradle));
  lesson.step("A stack", with(stack_of_boxes));
  lesson.deeper("A pyramid", with(wall_of_boxes));
  lesson.deeper("A heavy box on a light one", with(heavy_on_light));
  lesson.deeper("Where friction has no answer", with(no_answer));
  lesson.deeper("A lift", with(on_a_lift));

  lesson.closing(
      {.now_you_know =
           {R"(A contact is an inequality: JV + b ≥ 0, λ ≥ 0, one of them zero; the sum of all changes of λ is
            clamped.)",
            R"(A box that overlaps the ground by d leaves it at βd/h, and rises above it beyond about (1 −
            β/2)·2gh²/β²; split impulse forgets this velocity.)",
            "Friction is (16) within μ times the normal's λ; each row computes JV anew.",
            "A block sticks while tanθ ≤ μ; beyond, it slides by ½at(t + h).",
            "A bounce is b = e JV⁻, with JV⁻ where the fall meets the ground; reversed on overlap it gains h·v "
            "each time.",
            "Where many bodies touch at once, the rows give one answer and real balls another.",
            R"(Sweeps carry a stack's weight quickly, but not its bending: a stack of N boxes of height a whose
            overlaps are left uncorrected takes about ¾gh²N³/a warm sweeps to stand, or a direct solve.)"},
       .tries = {{"With each change clamped, from which width on does a box stay on its feet?",
                  "./lessons/run contact --step 1 --set width=0.25"},
                 {"Half the step: which of the stacks stand now, with the same sweeps?",
                  "./lessons/run contact --step 7 --set h=1/120"},
                 {"Half the step: which bounces come closer to the law?",
                  "./lessons/run contact --step 5 --set h=1/120"}},
       .next =
           R"(Write both clamps yourself, of contact and friction: `./lessons/run practise 9` and
           `./lessons/run practise 10`.

           Two rows made a contact with friction. In lesson 6 rows make joints: pins, welds, sliders, stops and
           motors.)"});
  return lesson.run(argc, argv);
}
