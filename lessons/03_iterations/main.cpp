// Lesson 3: many rows that share bodies, solved one after the other, over and over; and all at once.

#include "lessons/03_iterations/knobs.hpp"

using namespace byhand;
using namespace byhand::iterations;

int main(int argc, char** argv) {
  Lesson lesson(lesson_of(__FILE__));
  const Knobs knobs{
      .links = lesson.parameter("links", 10, "1", {2, 40}, "links of the chain"),
      .h = lesson.parameter("h", 1.0 / 60, "s", {1e-3, 0.05}, "time step"),
      .sweeps = lesson.parameter("sweeps", 10, "1", {1, 100},
                                 "sweeps a step in step 6, step 4's warm curve and step 7's interactive chain"),
      .beta = lesson.parameter("beta", 0.2, "1", {0, 1}, "share of the stretch that a step corrects (step 7)"),
      .start = lesson.parameter("start", "cold", {"cold", "warm"},
                                "what sweeps begin with: λ = 0, or the λ of the last step (step 7)"),
      .ratio = lesson.parameter("ratio", 100.0, "1", {1, 1000}, "mass of the end bob over the others (deeper)")};
  const auto step = [&](const char* title, void (*tell)(Page&, const Knobs&)) {
    lesson.step(title, [=](Page& page) { tell(page, knobs); });
  };
  const auto deeper = [&](const char* title, void (*tell)(Page&, const Knobs&)) {
    lesson.deeper(title, [=](Page& page) { tell(page, knobs); });
  };

  step("Two links that share a bob", two_links);
  step("A chain and one sweep", one_sweep);
  step("All at once", all_at_once);
  step("Many sweeps", many_sweeps);
  step("A chain twice as long", twice_as_long);
  step("Cold and warm over many steps", warm_start);
  step("1, 4, 16, 64 sweeps, and direct", side_by_side);
  lesson.hold(in_hand(knobs));
  deeper("A heavy end", heavy_end);
  deeper("What the direct solve costs", price_of_direct);
  deeper("Where Jacobi diverges", limit_of_jacobi);

  lesson.closing(
      {.now_you_know =
           {"(17) is exact for one row; for rows that share bodies it is one step of Gauss–Seidel.",
            R"(A sweep multiplies a chain's slowest error by cos²(π/2N), in any order: a chain twice as long needs
            about four times as many sweeps.)",
            "A warm start lets sweeps add up over the steps: each step multiplies the error by √q, and it rings.",
            "Too few sweeps make a chain soft, by an amount that can be computed.",
            "Solving all rows of a chain at once costs as much as a few sweeps and leaves only rounding error."},
       .tries = {{"A chain twice as long; look at the sweeps per digit:", "./lessons/run 3 --set links=20"},
                 {"Start the swinging chains warm: with few sweeps the correction makes them ring.",
                  "./lessons/run iterations --step 7 --set start=warm"},
                 {"One sweep a step, cold and warm:", "./lessons/run iterations --step 6 --set sweeps=1"}},
       .next =
           R"(Write the sweep yourself: `./lessons/run practise 7`.

           Lesson 4 is about drift: the cost of pulling stretched links back, and the β for which that is stable.)"});
  return lesson.run(argc, argv);
}
