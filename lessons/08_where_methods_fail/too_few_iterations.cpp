// Step 1: too few iterations.

#include "lessons/08_where_methods_fail/map.hpp"
#include "lessons/08_where_methods_fail/stack_film.hpp"
#include "lessons/08_where_methods_fail/steps.hpp"
#include "lessons/laws/closed_forms.hpp"
#include "lessons/laws/column.hpp"
#include "lessons/laws/creep.hpp"

namespace byhand::failures {
namespace {

using laws::Column;
using laws::Outcome;

double sweeps_to_stand(double boxes, double h = step) {
  return laws::sweeps_to_stand(static_cast<int>(boxes), gravity, h);
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

/// The gravity up to which a column of 8 boxes stands with one sweep in each of so many substeps, by bisection.
double gravity_held(int substeps) {
  constexpr int boxes = 8;
  const double law = laws::gravity_that_sweeps_hold(boxes, 1, step / substeps);
  return laws::bisect(
      [=](double gravity) {
        const Column column{
            .boxes = boxes, .sweeps = 1, .gravity = gravity, .substeps = substeps, .steps = 9000 / substeps};
        return laws::lean(column) == Outcome::settles;
      },
      0.7 * law, 1.5 * law, 0.01);
}

Film<PlaneBody> film(int boxes, int sweeps) {
  // More than a box sinks or tilts while it stands, or a warm start would remember the correction too (lesson 4).
  const Baumgarte slack{.slop = 0.1};
  return film_of_stacks(boxes,
                        {{several(sweeps, "sweep"), {GaussSeidel{sweeps}, slack}},
                         {"conjugate", {ConjugateSweeps{}, slack}},
                         {"direct", {Direct{}, slack}}},
                        4);
}

}  // namespace

void too_few_iterations(const Setting& setting, Page& page) {
  const int boxes = setting.boxes, sweeps = setting.sweeps;
  const double law = sweeps_to_stand(boxes);

  page.text(
      R"(This lesson sorts failures into five
      families by what is wrong: the rows are *not solved* well enough, a *correction* is too strong, the *step* is too
      long, the *model* is too soft, or the *rows* themselves are wrong. Each family has its symptom, and the symptom
      tells you which knob to turn. (One kind has no visible symptom: a method that holds every joint and
      loses energy, lesson 9.))");
  page.text(
      R"(**Symptom of the first family:** things give way slowly, always in the same direction, and *more sweeps help*.
      Chains sag, heavy boxes sink into light ones, stacks lean and fall. Rows are solved one after another, and a
      sweep passes on what a row has done only to its neighbours.)");
  page.text(
      R"(The slowest error of a chain of N links is a wave over its whole length; a sweep removes about π²/4N² of it
      (lesson 3). A stack has a slower one. When it leans, each contact must push harder on one side: the column
      *bends* like a beam. Meanwhile gravity tips it over. The column stands if the sweeps win this race.)");
  constexpr int few = 10, twice = 20;
  const double ratio = sweeps_to_stand(twice) / sweeps_to_stand(few);
  page.choose(
      {.ask = "A stack is twice as tall. By what factor must the number of sweeps per step grow?",
       .options =
           {{"2",
             "There are twice as many contacts, but a sweep also removes only a sixteenth as much of a "
             "bending mode."},
            {"4", "N² is the law of chains, which are stretched. A bending mode decays by only 2.06/N⁴ a sweep."},
            {"8",
             "A sweep removes a sixteenth as much of a bending mode, and the higher column tips half as fast: "
             "16/2."},
            {"16", "The sweeps do lose that much. But the higher column also tips more slowly."}},
       .answer = static_cast<int>(std::lround(std::log2(ratio))) - 1,
       .hints = {
           "What does a sweep remove of the lean, and what does gravity add to it?",
           "A sweep removes 2.06/N⁴ of a bending mode; in a step gravity adds (σh)² to a lean, σ² = 1.571 g/(Na).",
           "For twice N, the first is a sixteenth as large and the second is half as large."}});
  page.text(
      R"(A sweep removes only about 2.06/N⁴ of a bending mode, and under gravity a lean x of N boxes of height a grows
      as ẍ = σ²x, σ² = 1.571 g/(Na). With k sweeps a step from a warm start, the column stands if)");
  page.formula(
      "(σh)² < (1 − q)/q,   q = (1 − 2.06/N⁴)ᵏ:   k > about 0.763 g h² N³/a, @ for @ boxes of a = 1 m",
      R"((\sigma h)^2 < \frac{1-q}{q}, \quad q = \left(1 - \tfrac{2.06}{N^4}\right)^k: \quad k \gtrsim 0.763\, g h^2 N^3/a, \; @ \text{ for } @ \text{ boxes of } a = 1\,\mathrm{m})",
      Value(law, 3), boxes);
  page.derivation(
      "Why (σh)² < (1 − q)/q",
      {{"k sweeps leave the share q of what λ lacks; λ* would stop the lean, whose speed is v",
        "λₙ = λ* + q(λₙ₋₁ − λ*),   vₙ₋₁ + αλ* = 0",
        R"(\lambda_n = \lambda^* + q(\lambda_{n-1} - \lambda^*), \quad v_{n-1} + \alpha\lambda^* = 0)"},
       {"λ changes v by αλ; the last λ balanced the last pull of gravity, which has grown by σ²h²v",
        "vₙ = q(2 + σ²h²) vₙ₋₁ − q vₙ₋₂", R"(v_n = q(2 + \sigma^2h^2)\,v_{n-1} - q\,v_{n-2})"},
       {"insert vₙ = zⁿ", "z² − q(2 + σ²h²) z + q = 0", R"(z^2 - q(2 + \sigma^2h^2)\,z + q = 0)"},
       {"a root reaches z = 1 where", "1 + q = q(2 + σ²h²)   ⟹   (σh)² = (1 − q)/q",
        R"(1 + q = q(2 + \sigma^2h^2) \;\Rightarrow\; (\sigma h)^2 = \frac{1-q}{q})"},
       {"the slowest mode of a cantilever has the eigenvalue 1.8751⁴/N⁴; the stiffness matrix of bending has 6 on "
        "its diagonal",
        "1 − ρ = 1.8751⁴/(6N⁴) = 2.06/N⁴", R"(1 - \rho = \frac{1.8751^4}{6N^4} = \frac{2.06}{N^4})"},
       {"gravity acts on that mode φ(s), s being the height over Na",
        "σ² = (g/Na) ∫(1 − s)φ'² ds / ∫φ² ds = 1.571 g/(Na)",
        R"(\sigma^2 = \frac{g}{Na}\,\frac{\int(1-s)\,\varphi'^2\,ds}{\int\varphi^2\,ds} = \frac{1.571\,g}{Na})"},
       {"for many boxes (1 − q)/q ≈ 2.06 k/N⁴", "k > (N⁴/2.06) · 1.571 (g/Na) h² = 0.763 g h² N³/a",
        R"(k > \frac{N^4}{2.06}\cdot\frac{1.571\,g}{Na}h^2 = 0.763\,g h^2 N^3/a)"}});

  const Film<PlaneBody> stacks = film(boxes, sweeps);
  const double shown = stacks.hurry() * stacks.seconds();
  page.sequence(
      "leaning_stack",
      say(R"(@, pushed sideways at the top at @ m/s, shown at @ times the speed. With @ a step the stack @; with
          conjugate sweeps the stack @; solved directly it @. Right: how far the top box has moved@.)",
          several(boxes, "box", "boxes"), 0.02, stacks.hurry(), several(sweeps, "sweep"), stacks.fate(0),
          stacks.fate(1), stacks.fate(2), stacks.last(2) < 1e-5 ? " (solved directly: below the chart)" : ""),
      Seconds{stacks.seconds()}, stacks.drawing());
  const Quantity made("sweeps", sweeps), needed("sweeps of the law", law),
      made_over_needed("sweeps, over those of the law", sweeps / law),
      one_fold("1/σ", std::sqrt(boxes / (1.571 * gravity)));
  page.text(
      "The law asks for @ sweeps here. @", Value(law, 3),
      page.verdict(
          {{.when = both(stacks.fails(0), Quantity("seconds until it falls", stacks.ended_after(0)) < one_fold),
            .say = say(R"(With @ the rows are so poorly solved that the stack falls within 1/σ = @ s, before a lean
                       could grow: the law is about slower falls.)",
                       sweeps, Value(one_fold.value, 2))},
           {.when = stacks.fails(0),
            .say = say("With @ the stack leans further and further until it falls.", sweeps)},
           {.when = both(stacks.drifts(0), within(0.95, made_over_needed, 1.05)),
            .say =
                say("With @, at its very limit, the stack still leans further after these @ s.", sweeps, shown)},
           {.when = stacks.drifts(0),
            .say = say("With @ the stack still leans further after these @ s.", sweeps, shown)},
           {.when = made < needed, .say = say("With @ the stack still stands after these @ s.", sweeps, shown)},
           {.when = made >= needed,
            .say = say("So with @ this stack stands. Take more boxes or fewer sweeps to see it fall.", sweeps)}}));

  static std::map<int, Map> maps;
  const Map& map = kept(maps, setting.resolution, [&] {
    return map_of(page, counting_knob("boxes N", 4, 24, setting.resolution, renderer::Scale::linear),
                  counting_knob("warm sweeps a step", 1, 64, setting.resolution), [](double n, double k) {
                    return laws::lean(Column{.boxes = static_cast<int>(n), .sweeps = static_cast<int>(k)});
                  });
  });
  page.figure("boxes_and_sweeps",
              say("Each cell is one run of a column after a push of 10⁻⁷ m/s. Dashed: the law.@", on_ringing(map)),
              chart(
                  map, "(σh)² = (1 − q)/q, about 0.763 gh²N³/a", [](double n) { return sweeps_to_stand(n); },
                  stack_outcomes));
  const Agreement agreed = agreement(
      map, [](double n) { return sweeps_to_stand(n); }, Settles::above);
  page.text(agreed.sentence(true));
  static const double whole = gravity_held(1), cut = gravity_held(4);  // no knob changes them
  const std::string with_conjugate_sweeps =
      page.verdict({{.when = stacks.holds(1), .say = "With them the stack above stands."},
                    {.when = stacks.drifts(1), .say = "The stack above still leans."},
                    {.when = stacks.fails(1), .say = "The stack above still falls."}});
  page.text(
      R"(**Which knob?** More sweeps, but their number grows with N³. *Substeps* are cheaper: they divide each step
      into n shorter ones, each with its own J, gravity, solve and move. With n = 4, (σh)² is a sixteenth, so 4
      substeps of one sweep each hold what takes @ sweeps in one whole step. Conjugate sweeps (lesson 5, step 7a)
      reach slow errors sooner. @ And a *direct solve* leaves no error that could creep.)",
      Value(cut / whole, 2), with_conjugate_sweeps);
  page.text(
      R"(The *casebook* of this course takes complaints of users of engines, predicts what they saw, and shows the
      cure. Of this family: a heavy box that sinks through a light one, `./lessons/run case 1`; a box at rest that
      walks, `./lessons/run case 4`; a stack that falls after some seconds, `./lessons/run case 5`; a box that bounces
      to one side, `./lessons/run case 6`.)");

  claim_agreement(page, agreed, 0.15, "law of creep", setting.resolution);
  const Condition in_reach = within(1.5, Quantity("0.763 gh²N³/a", law), 40);
  if (in_reach)
    page.claim(say("sweeps from which @ boxes stand after a push of 10⁻⁷ m/s, by bisection", boxes),
               1.0 * fewest_sweeps(boxes, static_cast<int>(2 * law) + 2), "1",
               is(law, "law of creep, and the next whole number", absolute(1 + 0.05 * law)), in_reach);
  page.claim("gravity that 4 substeps of one sweep hold, over one step of one sweep", cut / whole, "1",
             is(16, "law of creep: it counts h²", relative(0.05)));
  const Condition above = Quantity("sweeps", sweeps) > Quantity("1.2 · 0.763 gh²N³/a", 1.2 * law);
  if (above)
    page.claim("stack with sweeps above the law: whether it falls in the film", stacks.failed(0) ? 1.0 : 0.0, "1",
               is(0, "law of creep", absolute(0)), above);
  page.claim("solved directly, the top box has moved at the end", stacks.last(2), "m",
             is_at_most(0.01, "law of exact stacks: it stands"));
}

}  // namespace byhand::failures
