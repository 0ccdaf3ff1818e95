// Lesson 9: what accuracy costs, by method, by model, and for the reader's own scene.

#include "lessons/09_what_accuracy_costs/steps.hpp"
#include "lessons/catalogue/catalogue.hpp"

int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::accuracy;

  course::Lesson lesson(course::lesson_of(__FILE__));
  std::vector<std::string> scenes;
  for (const NamedScene& scene : catalogue()) scenes.push_back(scene.name);
  const accuracy::Setting setting{
      .scene = lesson.parameter("scene", "chain", scenes,
                                "scene of step 7, to which all of these belong but `appendix`"),
      .drift =
          lesson.parameter("drift", 0.0, "m", {0, 0.1},
                           "largest separation or overlap allowed; 0: any, or 1 mm if nothing else is asked for"),
      .trajectory = lesson.parameter("trajectory", 0.0, "m", {0, 100}, "distance from the true motion; 0: any"),
      .energy = lesson.parameter("energy", 0.0, "1", {0, 100}, "change of energy over m·g·L of the scene; 0: any"),
      .momentum = lesson.parameter("momentum", 0.0, "1", {0, 100}, "change of angular momentum; 0: any"),
      .reaction = lesson.parameter("reaction", 0.0, "1", {0, 100}, "error of the reaction force; 0: any"),
      // A search tries what the budget allows: at a millisecond it takes half a minute, and a second would take
      // hours.
      .budget = lesson.parameter("budget", 0.0, "s", {0, 1e-3}, "time a frame, such as 200us; 0: any"),
      .links = lesson.parameter("links", Initial::links, "1", {1, 500}, "of the chain"),
      .end_mass =
          lesson.parameter("end_mass", Initial::end_mass, "kg", {1e-3, 1e6}, "of the chain or double pendulum"),
      .mass = lesson.parameter("mass", Initial::mass, "kg", {1e-3, 1e3}, "of a link, bar, bob or block"),
      .length = lesson.parameter("length", Initial::length, "m", {0.01, 100}, "of a link, bar or rod"),
      .boxes = lesson.parameter("boxes", Initial::boxes, "1", {1, 100}, "of the stack"),
      .top_mass =
          lesson.parameter("top_mass", Initial::top_mass, "kg", {1e-3, 1e6}, "of the topmost box of the stack"),
      .base = lesson.parameter("base", Initial::base, "1", {1, 30}, "boxes in the lowest row of the pyramid")};
  const course::Parameter<std::string> charts_of =
      lesson.parameter("appendix", "none", appendix_scenes(), "which further charts the appendix draws");

  lesson.step("The methods that compete", the_methods);
  lesson.deeper("The other methods", other_methods);
  lesson.step("Reading the order off a chart", order_is_the_slope);
  lesson.step("Stable is not accurate", stable_is_not_accurate);
  lesson.deeper("The longest stable step", stability);
  lesson.step("Substeps or sweeps", substeps_or_sweeps);
  lesson.deeper("More sweeps", what_the_step_hides);
  lesson.deeper("A tolerance in place of a step", accuracy_as_the_input);
  lesson.step("Stacks and pyramids", contacts);
  lesson.step("One picture and one table", one_page);
  lesson.step("Ask the program", [=](course::Page& page) { recommendation(page, setting); });
  lesson.answers({"scene", "drift", "trajectory", "energy", "momentum", "reaction", "budget", "links", "end_mass",
                  "mass", "length", "boxes", "top_mass", "base"});
  lesson.deeper("What the model costs", model_cost);
  lesson.deeper("Appendix: further charts, and where the equations are",
                [=](course::Page& page) { appendix(page, charts_of); });
  lesson.answers({"appendix"});

  lesson.closing(
      {.now_you_know =
           {R"(The order of a method is the slope of its error against the step on two logarithmic axes. Where a curve
            turns straight up, its knob no longer reduces the error.)",
            R"(Drift, trajectory, energy, momentum, reaction force and algebraic error are six different errors, and no
            method is best in all.)",
            R"(For the same row-solves, many short steps are more accurate than one step solved well; but each writes
            its rows anew, and that must be counted.)",
            "A run that falls or comes apart is cheap. It must stand or hold before its errors count.",
            R"(A few bodies: to 1 %, one sweep a step is usually cheapest. For a trajectory to 0.01 %, RK4: in
            generalised coordinates, or on the accelerations where the bodies close a loop. Long or heavily loaded chains and columns: solve directly, or use
            joint coordinates. Contacts with loops (pyramids): sweeps.)",
            "A model with more numbers than a scene needs gives the same motion for more bytes and more time."},
       .tries = {{"The heavy chain: what is cheapest for a millimetre?",
                  "./lessons/run 9 --set scene=chain --set links=50 --set end_mass=100 --set drift=1e-3"},
                 {"The other way round: what does a fifth of a millisecond a frame buy?",
                  "./lessons/run 9 --set scene=chain --set links=50 --set budget=200us"},
                 {"Both at once: a drift within a time limit:",
                  "./lessons/run 9 --set scene=stack --set drift=5cm --set budget=1ms"},
                 {"A reaction force within one per cent, in a four-bar linkage:",
                  "./lessons/run 9 --set scene=four_bar --set reaction=0.01"},
                 {"A tenth of a nanometre, for which the error of the step itself must be tiny:",
                  "./lessons/run 9 --set scene=spherical_pendulum --set trajectory=1e-10"}},
       .next = "Choose a scene of your own and ask the program. Lesson 10 puts these scenes into the engines that "
               "people use."});
  return lesson.run(argc, argv);
}
