#include "lessons/08_where_methods_fail/steps.hpp"

// Where methods fail: five families, each with its symptom, its law, a map of the law's limit, and the knob that
// helps.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::failures;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .resolution = lesson.parameter("resolution", 20, "1", {4, 64}, "cells along each side of a map"),
      .boxes = lesson.parameter("boxes", 15, "1", {8, 24}, "in the stack that leans, step 1"),
      .sweeps =
          lesson.parameter("sweeps", 4, "1", {1, 30}, "sweeps a step, for the stack and for the chain that rings"),
      .beta = lesson.parameter("beta", 0.3, "1", {0.01, 1}, "share of an error that a step corrects"),
      .end_mass =
          lesson.parameter("end_mass", 600.0, "kg", {1, 1e5}, "at the end of the chain, whose links weigh 1 kg"),
      .hertz = lesson.parameter("hertz", 30.0, "Hz", {10, 60}, "frequency of soft contacts"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("Too few iterations", with(too_few_iterations));
  lesson.hold(stack_in_hand(setting));
  lesson.step("The correction overshoots", with(overshoots));
  lesson.step("The step is too large", with(too_large_a_step));
  lesson.hold(chain_in_hand(setting));
  lesson.step("The contact is too soft", with(too_soft));
  lesson.step("The rows are wrong", with(wrong_rows));
  lesson.step("Which knob?", with(which_knob));
  lesson.step("All laws", with(all_laws));

  lesson.deeper("Which regime is my scene in?", with(regimes));
  lesson.deeper("A heavy box on a light one", with(heavy_on_light));
  lesson.deeper("Four contacts on one box", with(many_contacts));
  lesson.deeper("Explicit springs", with(springs));
  lesson.deeper("Tunnelling", with(unseen));

  lesson.closing(
      {.now_you_know =
           {R"(It gives way slowly, in one direction, and more sweeps help: too few iterations. The sweeps needed grow
            as N² for chains and as N³ for stacks; a direct solve needs none.)",
            R"(It rings: the correction is too strong. From a warm start a chain needs β < (1 − q)/q, and never more
            than 2.)",
            R"(It flies apart, and more sweeps change nothing: the step is too long. Sideways a taut chain is an
            explicit spring, ωh < 2.)",
            "It leans and falls, and neither sweeps nor substeps help: the model is too soft. A stack on soft "
            "contacts buckles.",
            "It is calm while λ grows: the rows are wrong. Regularise, reorder or refresh them.",
            "Look at the symptom first: no knob cures every failure."},
       .tries = {{"A finer map of where a warm start rings:", "./lessons/run 8 --step 2 --set resolution=40"},
                 {"A taller stack, with more sweeps but not enough:",
                  "./lessons/run 8 --step 1 --set boxes=20 --set sweeps=12"},
                 {"A lighter end, below the limit:", "./lessons/run 8 --step 3 --set end_mass=200"},
                 {"Stiffer contacts and taller stacks:", "./lessons/run 8 --step 4 --set hertz=60"}},
       .next =
           "Lesson 9 stays within these limits and asks what accuracy costs there: error against work, for every "
           "method."});
  return lesson.run(argc, argv);
}
