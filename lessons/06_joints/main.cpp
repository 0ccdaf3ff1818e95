#include "lessons/06_joints/steps.hpp"

// Joints: systems of rows with bounds, alone and in machines, and what happens where rows repeat or contradict.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::joints;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .h = lesson.parameter("h", 1.0 / 60, "s", {1.0 / 400, 0.03}, "time step"),
      .side = lesson.parameter("side", 0.2, "m", {0.05, 2}, "side of the box on the arm (step 2)"),
      .angle =
          lesson.parameter("angle", 60.0, "deg", {5, 85}, "from which the four-bar linkage is released (step 3)"),
      .strength =
          lesson.parameter("strength", 0.25, "mgl", {0.05, 0.48}, "of the motor that is too weak (step 5)"),
      .speed = lesson.parameter("speed", 6.0, "rad/s", {1, 20}, "of the motor (step 6)"),
      .sweeps = lesson.parameter("sweeps", 10, "1", {1, 30}, "sweeps a step (steps 2, 7)"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("From rows to joints", with(rows_to_joints));
  lesson.step("Block or row", with(block_or_row));
  lesson.step("A four-bar linkage", with(four_bar_linkage));
  lesson.hold(in_hand(setting));
  lesson.step("Counting again", with(flat));
  lesson.step("Stops and motors are rows with bounds", with(bounds_on_turns));
  lesson.step("A motor drives a slider-crank", with(driven_crank));
  lesson.step("Rods that repeat and rods that contradict", with(conflicting_rods));

  lesson.deeper("A rope", with(ropes));
  lesson.deeper("A spring is a soft row", with(soft_rows));
  lesson.deeper("A bridge", with(hanging_bridge));
  lesson.deeper("A ragdoll on the stairs", with(ragdoll_on_a_stair));

  lesson.closing(
      {.now_you_know =
           {R"(A joint is K rows of the kind you know: a pin two, a weld three, a slider two. A stop, a motor and a rope
            are one row within bounds.)",
            "A motor told to stand still, with a bound, is dry friction in the joint.",
            "Rows that act through the same arm belong in one block; row by row a sweep leaves A₁₂²/(A₁₁A₂₂).",

            R"(Degrees of freedom are velocities less *rank*. Where rows repeat, A is singular, and a regularisation
            makes λ unique.)",
            R"(With a warm start the λ of rows that contradict each other grows in every step while nothing moves: test
            |λ|, not the picture.)"},
       .tries = {{"A box as large as its arm: does it still matter whether you solve a block or rows?",
                  "./lessons/run joints --step 2 --set side=2"},
                 {"A stronger motor: where does the bar rest now?",
                  "./lessons/run joints --step 5 --set strength=0.4"},
                 {"One sweep a step: how fast does λ grow now?", "./lessons/run joints --step 7 --set sweeps=1"}},
       .next = "Lesson 7 leaves the plane: the same code with three axes of rotation."});
  return lesson.run(argc, argv);
}
