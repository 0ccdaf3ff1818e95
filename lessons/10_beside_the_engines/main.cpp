#include "lessons/10_beside_the_engines/field.hpp"
#include "lessons/10_beside_the_engines/steps.hpp"

// Beside the engines: the course's scenes in engines that other people use, measured by the same functions.
int main(int argc, char** argv) {
  using namespace byhand;
  using namespace byhand::beside;

  course::Lesson lesson(course::lesson_of(__FILE__));
  const Setting setting{
      .links = lesson.parameter("links", 50, "1", {2, 200}, "in the chain"),
      .end_mass =
          lesson.parameter("end_mass", 100.0, "kg", {1, 1000}, "at the end of the chain, whose links weigh 1 kg"),
      .base = lesson.parameter("base", 20, "1", {3, 20}, "boxes in the lowest row of the pyramid"),
      .boxes = lesson.parameter("boxes", 10, "1", {2, 30}, "in the stack"),
      .friction = lesson.parameter("friction", 0.5, "1", {0.1, 0.9}, "μ of the block on a slope"),
  };
  const auto with = [setting](void (*step)(const Setting&, course::Page&)) {
    return [=](course::Page& page) { step(setting, page); };
  };

  lesson.step("The engines", with(the_engines));
  lesson.step("Two pendulums", with(pendulums));
  lesson.step("A chain with a load", with(chains));
  lesson.step("A stack", with(stacks));
  lesson.step("A block on a slope", with(block_on_a_slope));
  lesson.step("A pyramid", with(wall_of_boxes));
  lesson.deeper("The chain in space", with(chain_in_space));
  lesson.deeper("Stacks in space", with(stacks_in_space));
  lesson.deeper("The pyramid in space", with(wall_in_space));
  lesson.deeper("Engines in WebAssembly", with(in_webassembly));

  std::vector<std::string> known{
      "Two engines can be compared only in the same scene, by the same measure and over the same time, each with "
      "its own settings tuned. Another time or place may rank them otherwise.",
      "Engines that share a scheme share the error of a single joint that is solved to the end, whoever wrote "
      "them."};
  if (alone()) {
    known.emplace_back("With one engine only, this lesson shows how to measure, not who is better.");
  } else {
    known.emplace_back(
        "Most engines' defaults are chosen for speed (few steps, few iterations) and calm (an overlap that is "
        "left). Each is a term of its error.");
    known.emplace_back(
        "On velocities alone a load on a chain needs short steps: an exact solve tears it where the step is too "
        "long. There coordinates that cannot part explode. A tall stack needs short steps, many iterations or a "
        "direct solve that converges; contacts that give way need short steps as well.");
    const auto soft = [](const auto& engine) { return engine.name == "Box2D 3" || engine.name == "Box3D"; };
    if (std::any_of(engines::all_engines().begin(), engines::all_engines().end(), soft))
      known.emplace_back(
          "If an engine gives its joints a stiffness in hertz and caps it by the rate of substeps, as Box2D 3 "
          "does, more substeps alone do not make them stiffer beyond that; raise the frequency too.");
    known.emplace_back("A time belongs to one machine; the ratio of two times in one run says more.");
  }
  lesson.closing(
      {.now_you_know = known,
       .tries = {{"A short chain with a light end, which whips:",
                  "./lessons/run 10 --step 3 --set links=10 --set end_mass=1"},
                 {"A taller stack:", "./lessons/run 10 --step 4 --set boxes=20"},
                 {"A slippery slope:", "./lessons/run 10 --step 5 --set friction=0.1"}},
       .next = "This was the last lesson. Take a scene of your own to the engine that you use, and measure."});
  return lesson.run(argc, argv);
}
