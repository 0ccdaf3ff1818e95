// Lesson 3: many rows that share bodies, solved one after the other, over and over; and all at once.

#include "lessons/03_iterations/knobs.hpp"

using namespace byhand;
using namespace byhand::iterations;
using namespace byhand::tutor;

int main(int argc, char** argv) {
  Lesson lesson(contents().at(2));
  const Knobs knobs{
      .links = lesson.parameter("links", 10, "1", {2, 40}, "links of the chain"),
      .length = lesson.parameter("length", 2.0, "m", {0.1, 10}, "length of a link"),
      .mass = lesson.parameter("mass", 3.0, "kg", {0.1, 100}, "mass of a bob"),
      .h = lesson.parameter("h", 1.0 / 60, "s", {1e-3, 0.05}, "time step"),
      .sweeps = lesson.parameter("sweeps", 10, "1", {1, 100}, "sweeps a step where a chain is stepped (step 6)"),
      .beta = lesson.parameter("beta", 0.2, "1", {0, 1}, "share of the stretch that a step corrects (step 7)"),
      .angle = lesson.parameter("angle", 20.0, "°", {1, 80}, "from which the chain is released (step 7)"),
      .warm = lesson.parameter("warm", 0, "1", {0, 1}, "1: steps begin with the λ of the last one (step 7)"),
      .ratio = lesson.parameter("ratio", 100.0, "1", {1, 1000}, "mass of the end bob over the others (deeper)")};
  const auto step = [&](const char* title, void (*tell)(Page&, const Knobs&)) {
    lesson.step(title, [=](Page& page) { tell(page, knobs); });
  };
  const auto deeper = [&](const char* title, void (*tell)(Page&, const Knobs&)) {
    lesson.deeper(title, [=](Page& page) { tell(page, knobs); });
  };

  step("Two links undo each other's work", two_links);
  step("Ten links, one sweep", one_sweep);
  step("All at once", all_at_once);
  step("Many sweeps", many_sweeps);
  step("Why twice as long takes four times as many", twice_as_long);
  step("What a warm start buys", warm_start);
  step("1, 4, 16, 64 sweeps, and direct", side_by_side);
  deeper("A heavy end", heavy_end);
  deeper("What the direct solve costs", price_of_direct);
  deeper("Where Jacobi fails", limit_of_jacobi);

  lesson.closing(
      {.now_you_know =
           {"(17) is exact for one row; for rows that share bodies it is one sub-step of Gauss–Seidel.",
            R"(A sweep leaves the share cos²(π/2N) of a chain's slowest error, in any order: twice as long, four
            times as many sweeps.)",
            "A warm start is a head start in one step and the whole way over many; it rings.",
            "Too few sweeps make a chain soft, by an amount that can be computed.",
            "All rows at once cost a chain no more than a few sweeps, and nothing is left over."},
       .tries = {{"A chain twice as long; look at the sweeps for a digit:", "./lessons/run 3 --set links=20"},
                 {"Start the swinging chains warm: with few sweeps, memory and correction fight.",
                  "./lessons/run iterations --step 7 --set warm=1"},
                 {"One sweep a step, cold and warm:", "./lessons/run iterations --step 6 --set sweeps=1"}},
       .next =
           "Write the sweep yourself: `./lessons/run practise 7`.\n\n"
           "Lesson 4 takes up the drift: what pulling stretched links back costs, and where it stops working."});
  return lesson.run(argc, argv);
}
