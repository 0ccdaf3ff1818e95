// Step 1: too few iterations.

#include <cmath>

#include "lessons/08_where_methods_fail/laws/column.hpp"
#include "lessons/08_where_methods_fail/laws/creep.hpp"
#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/stack_film.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"

namespace byhand::failures {
namespace {

using namespace tutor;
using laws::Column;
using laws::Outcome;

/// The sweeps from which a column stands: (σh)² < (1 − q)/q, q = ρᵏ.
double sweeps_to_stand(double boxes, double h = step) {
  const int n = static_cast<int>(boxes);
  return std::log1p(laws::tipping_rate_squared(n, gravity) * h * h) / -std::log(laws::bending_left_by_a_sweep(n));
}

bool stands(int boxes, int sweeps) {
  // Long enough for what is slowest to grow or to die.
  const double left = std::pow(laws::bending_left_by_a_sweep(boxes), sweeps);
  return laws::lean(Column{.boxes = boxes, .sweeps = sweeps, .steps = static_cast<int>(4 / (1 - left)) + 1000}) ==
         Outcome::settles;
}

/// The fewest sweeps with which it stands, by halving.
int fewest_sweeps(int boxes, int most) {
  int falls = 0, standing = most;
  while (standing - falls > 1) {
    const int middle = (falls + standing) / 2;
    (stands(boxes, middle) ? standing : falls) = middle;
  }
  return standing;
}

Film<PlaneBody> film(int boxes, int sweeps) {
  const Baumgarte slack{.slop = 0.01};
  return film_of_stacks(boxes,
                        {{say("@ sweeps", sweeps), {GaussSeidel{sweeps}, slack}},
                         {"conjugate", {ConjugateSweeps{}, slack}},
                         {"direct", {Direct{}, slack}}},
                        4);
}

}  // namespace

void too_few_iterations(const Setting& setting, Page& page) {
  const int boxes = setting.boxes, sweeps = setting.sweeps;
  const double law = sweeps_to_stand(boxes);

  page.text(
      R"(Methods fail in four ways, and no more. Each has its own symptom, its own law, and its own cure; a cure
      for one does nothing for another. So learn to tell them apart.)");
  page.text(
      R"(**Symptom of the first:** it gives way slowly, always in the same direction, and *each further sweep makes
      it better*. Chains sag, heavy boxes crush light ones, stacks lean and fall. Rows are solved one after the
      other, and the news of what one of them did has not come round yet.)");
  page.text(
      R"(A chain's slowest error is a wave, of which a sweep takes about π²/4N² (lesson 3). A stack has a slower
      one. When it leans, each contact must press more on one side: the column *bends*, like a beam, and a sweep
      takes about 2/N⁴ of a bending. All the while gravity tips it over like a pencil, by (σh)² a step, σ² about
      3g/2N. It stands if the sweeps are quicker:)");
  page.formula(
      "(σh)² < (1 − q)/q,   q = (1 − 2/N⁴)ᵏ:   k > about ¾ g h² N³, @ sweeps for @ boxes",
      R"((\sigma h)^2 < \frac{1-q}{q}, \quad q = \left(1 - \tfrac{2}{N^4}\right)^k: \quad k \gtrsim \tfrac34\, g h^2 N^3, \; @ \text{ sweeps for } @ \text{ boxes})",
      Value(law, 3), boxes);
  constexpr int few = 10, twice = 20;
  const int for_few = fewest_sweeps(few, 16), for_twice = fewest_sweeps(twice, 64);
  page.predict(
      {.ask = say("@ boxes need @ sweeps a step to stand. How many do @ boxes need?", few, for_few, twice),
       .answer = static_cast<double>(for_twice),
       .unit = "sweeps",
       .tolerance = 0.2 * for_twice,
       .wrong = {{2.0 * for_few,
                  "Not only are there twice as many contacts: bending is slower by N⁴, toppling by N."},
                 {16.0 * for_few, "N⁴ is what a sweep leaves; but a tall column also topples more slowly, by N."}},
       .hints = {"What a sweep takes falls with N⁴. What gravity adds falls with N."},
       .right = "N⁴ for the bending, less N for the toppling: about the cube."});

  const Film<PlaneBody> stacks = film(boxes, sweeps);
  page.sequence("leaning_stack",
                say(R"(@ boxes after a kick of @ m/s at the top, @ times as fast as it was. @ sweeps a step: @. By
                    conjugate sweeps (NNCG): @. Directly: @. Right: how far the top box is from where it stood
                    (directly: less than can be shown).)",
                    boxes, 0.02, stacks.hurry(), sweeps, stacks.fate(0), stacks.fate(1), stacks.fate(2)),
                Seconds{stacks.seconds()}, stacks.drawing());

  const Map map =
      map_of(page, counting_knob("boxes N (1)", 4, 24, setting.resolution, renderer::Scale::linear),
             counting_knob("warm sweeps a step (1)", 1, 64, setting.resolution), [](double n, double k) {
               return laws::lean(Column{.boxes = static_cast<int>(n), .sweeps = static_cast<int>(k)});
             });
  page.figure("boxes_and_sweeps",
              R"(Each cell is a run of a column that was nudged. "Explodes" is: has fallen. Dashed: the law.)",
              chart(map, "(σh)² = (1 − q)/q, about ¾ gh²N³", [](double n) { return sweeps_to_stand(n); }));
  const double foreseen = share_foreseen(map, [](double n, double k) { return k > sweeps_to_stand(n); });
  page.text("Of @ runs the law foresees @ %.", map.outcomes.size(), Value(100 * foreseen, 3));
  page.text(
      R"(**Which knob?** Sweeps, but N³ of them. Substeps are better: in @ of them (σh)² is a @th each, so @
      substeps of one sweep hold what asks for @ sweeps of a whole step. Conjugate sweeps reach a slow mode as the
      square root of what plain ones need. And *structure* ends it: a column is a chain, and a direct solve leaves
      nothing over that could creep.)",
      4, 16, 4, Value(std::round(sweeps_to_stand(twice) / sweeps_to_stand(twice, step / 4)), 2));

  page.claim({.quantity = "share of runs that end as the law says",
              .unit = "1",
              .expected = 0.9,
              .source = "law B18",
              .measured = foreseen,
              .tolerance = at_least(),
              .claimed = setting.resolution >= 10,
              .range = "10 cells a side or more"});
  const bool in_reach = law > 1.5 && law < 40;
  page.claim({.quantity = say("fewest sweeps with which @ boxes stand, by bisection", boxes),
              .unit = "1",
              .expected = law,
              .source = "law B18, and the next whole number",
              .measured = in_reach ? 1.0 * fewest_sweeps(boxes, static_cast<int>(2 * law) + 2) : 0,
              .tolerance = absolute(1 + 0.05 * law),
              .claimed = in_reach,
              .range = "1.5 < ¾gh²N³ < 40"});
  page.claim({.quantity = "solved directly, the top box is off at the end",
              .unit = "m",
              .expected = 0.01,
              .source = "law B20: it stands",
              .measured = stacks.last(2),
              .tolerance = at_most()});
}

}  // namespace byhand::failures
