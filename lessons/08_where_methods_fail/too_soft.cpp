// Step 4: the contact is too soft.

#include <cmath>
#include <numbers>

#include "lessons/08_where_methods_fail/laws/buckling.hpp"
#include "lessons/08_where_methods_fail/laws/column.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/stack_film.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::Outcome;

// More than law 18 asks for. Solved exactly the boundary is the same, but what has buckled goes slowly.
constexpr int sweeps = 40, sweeps_filmed = 100;

Outcome nudged(int boxes, double hertz) {
  return laws::buckle({.boxes = boxes, .sweeps = sweeps, .frequency = hertz, .steps = 900});
}

/// Whether it stands if each step is solved exactly.
bool stands(int boxes, double hertz) {
  return laws::buckle({.boxes = boxes, .sweeps = 0, .frequency = hertz}) == Outcome::settles;
}

/// The tallest column that stands on contacts of this frequency, by building it up.
int tallest(double hertz) {
  int boxes = 2;
  while (boxes < 40 && stands(boxes + 1, hertz)) ++boxes;
  return boxes;
}

Film<PlaneBody> film(int boxes, double hertz) {
  const auto soft = [](std::string name, double frequency, int substeps) {
    return SolvedStack{std::move(name),
                       {.solver = GaussSeidel{sweeps_filmed},
                        .drift = SoftConstraints{.frequency = 2 * std::numbers::pi * frequency},
                        .substeps = substeps}};
  };
  return film_of_stacks(boxes,
                        {soft(say("@ Hz", hertz), hertz, 1), soft(say("@ Hz, 4 substeps", hertz), hertz, 4),
                         soft(say("@ Hz", 4 * hertz), 4 * hertz, 1)},
                        3);
}

}  // namespace

void too_soft(const Setting& setting, Page& page) {
  const double hertz = setting.hertz;
  const int highest = tallest(hertz), filmed = highest + highest / 3 + 1, twice = tallest(2 * hertz);

  page.text(
      R"(**The same family, another face.** Engines make contacts soft, each a damped spring tuned to a frequency ω
      that suits the box alone: k = mω². It is stable at every ωh, and the stack of such boxes leans, bows and
      falls. *Neither sweeps nor substeps change when*: the springs are solved as well as you like, and they are
      springs.)");
  page.text(
      R"(It is the oldest law here. In 1881 A. G. Greenhill asked how tall a tree can grow before it buckles under
      its own weight. A column of N boxes on soft faces is his tree: a box that turns by θ is set up by kw²θ/2
      across its width w, and tipped over by all that stands above.)");
  page.formula("N³ < 7.84 k w²/(2 m g):   @ boxes at @ Hz",
               R"(N^3 < 7.84\,\frac{k w^2}{2 m g}: \quad @ \text{ boxes at } @\ \mathrm{Hz})", highest, hertz);
  page.predict(
      {.ask = say("Contacts of @ Hz bear @ boxes. How many do contacts of @ Hz bear?", hertz, highest, 2 * hertz),
       .answer = static_cast<double>(twice),
       .unit = "boxes",
       .tolerance = 0.12 * twice,
       .wrong = {{2.0 * highest,
                  "Stiffness goes with the square of the frequency, and height with its cube root."},
                 {4.0 * highest, "k is four times as large, but N³ is what it bears."},
                 {static_cast<double>(highest), "Stiffness is the one thing that helps."}},
       .hints = {"k grows with ω², and N³ with k."},
       .right = "The cube root of four: 1.59 times as many."});

  const Film<PlaneBody> stacks = film(filmed, hertz);
  page.sequence(
      "buckling_stack",
      say(R"(@ boxes on soft contacts, @ sweeps a step, after a small kick; @ times as fast as it was. @ Hz: @. In
          4 substeps: @. @ Hz: @.)",
          filmed, sweeps_filmed, stacks.hurry(), hertz, stacks.fate(0), stacks.fate(1), 4 * hertz, stacks.fate(2)),
      Seconds{stacks.seconds()}, stacks.drawing());

  const Map map = map_of(page, counting_knob("boxes N (1)", 4, 22, setting.resolution, renderer::Scale::linear),
                         knob("frequency of the contacts (Hz)", 8, 100, setting.resolution),
                         [](double n, double hz) { return nudged(static_cast<int>(n), hz); });
  const auto boundary = [](double n) { return laws::softest_contacts(static_cast<int>(std::lround(n))); };
  page.figure(
      "boxes_and_stiffness",
      say(R"(Each cell is a run of a nudged column at 60 Hz, @ sweeps a step, more than enough. "Drifts" is: leans
          further and further. "Explodes" is: has fallen. Dashed: Greenhill's law for N boxes.)",
          sweeps),
      chart(map, "N³ = 7.84 kw²/2mg", boundary));
  const double foreseen = share_foreseen(map, [&](double n, double hz) { return hz > boundary(n); });
  page.text("Of @ runs the law foresees @ %.", map.outcomes.size(), Value(100 * foreseen, 3));
  page.text(
      R"(**Which knob?** Stiffness. Engines do not let a contact be stiffer than a quarter of the rate of steps, so
      their substeps help after all: they allow stiffer contacts. Hard contacts have no such limit, only that of
      the first family.)");

  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.93,
              .source = "law B17",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  const bool in_reach = highest >= 8 && highest <= 30;
  const double law = laws::softest_contacts(highest);
  page.claim({.quantity = say("softest contacts on which @ boxes stand, by bisection", highest),
              .unit = "Hz",
              .expected = law,
              .source = "law B17, for so many boxes",
              .measured = in_reach ? laws::bisect([=](double hz) { return stands(highest, hz); }, 0.6 * law,
                                                  1.6 * law, 0.004)
                                   : 0,
              .tolerance = relative(0.04),
              .claimed = in_reach,
              .range = "8 to 30 boxes"});
}

}  // namespace byhand::failures
