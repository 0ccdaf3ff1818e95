// Deeper: a heavy bob at the end.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/textbook.hpp"

namespace byhand::iterations {
namespace {

ChainOptions with_heavy_end(ChainOptions chain, double ratio) {
  chain.end_mass = ratio * chain.mass;
  return chain;
}

double textbook_digit(const ChainOptions& chain) {
  const double factor = textbook_jacobi_factor(textbook_matrix(chain));
  return sweeps_per_digit(factor * factor);
}

}  // namespace

void heavy_end(Page& page, const Knobs& knobs) {
  const int n = knobs.links;
  const double h = knobs.h, ratio = knobs.ratio;
  const ChainOptions heavy = with_heavy_end(knobs.chain(), ratio);
  const double light_digit = measured_digit(knobs.chain(), h), heavy_digit = measured_digit(heavy, h);

  const double change = heavy_digit / light_digit;
  if (ratio == 1)
    page.text(
        R"(With `ratio` = 1 all bobs are equal, and this is the chain of step 4: @ sweeps for a digit. Set `ratio` to 100 to
        hang a heavy bob at the end.)",
        Value(light_digit, 4));
  else
    page.text("The same @ links, but the bob at the end has @ the mass of each other bob.", n,
              ratio == 2 ? std::string("twice") : say("@ times", ratio));
  if (change > 1.1)
    page.choose(
        {.ask =
             say(R"(With equal bobs one more digit takes @ sweeps. Does this chain take fewer, as many, or more?)",
                 Value(light_digit, 3)),
         .options = {{"fewer",
                      "The last row's impulse moves mostly its light bob; the heavy one changes its speed less."},
                     {"as many", "Mass cancels in one pendulum, not between the two bobs of a row."},
                     {"more", say(R"(It takes @ sweeps, @ times as many. The last row's impulse gives the
                                  heavy bob 1/(1 + r) of the change of speed, so the weight goes up the chain in
                                  small portions.)",
                                  Value(heavy_digit, 4), Value(change, 3))}},
         .answer = 2,
         .hints = {
             "The last row's impulse is the same for the light bob and the heavy one. Which of them does it move?",
             "(20): Δv = λl/m.", say("The heavy bob takes 1/(1 + @) of the difference in speed.", ratio)}});
  else if (ratio > 1)
    page.text("One more digit takes @ sweeps, and @ with equal bobs. Set `ratio` to 100.", Value(heavy_digit, 4),
              Value(light_digit, 4));
  if (ratio > 1)
    page.text(
        R"(Let r be the ratio of the masses. The last row finds the heavy bob falling away from the light one and makes
      their speeds equal. The light bob takes the share r/(1 + r) = @ of the change, the heavy one 1/(1 + r) = @. Then
      the row above corrects the light bob.

      If r is much larger than N: let the heavy bob fall at v. Once the light bobs have settled, their speeds fall off
      evenly to 0, by v/(N − 1) a rod: in each sweep every row passes on an impulse of m·v/(N − 1). The heavy bob
      loses v/(r(N − 1)): ρ ≈ 1 − 1/(r(N − 1)).)",
        Value(ratio / (1 + ratio), 4), Value(1 / (1 + ratio), 3));
  renderer::Curve measured{.label = "measured", .style = renderer::CurveStyle::markers};
  renderer::Curve exact{.label = "exact (largest eigenvalue)", .style = renderer::CurveStyle::theory};
  renderer::Curve law{.label = "r ≫ N: ln 10 · r(N − 1)",
                      .style = renderer::CurveStyle::theory,
                      .colour = renderer::palette::force};
  for (const double r : {1.0, 3.0, 10.0, 30.0, 100.0, 300.0, 1000.0}) {
    const ChainOptions chain = with_heavy_end(knobs.chain(), r);
    measured.x.push_back(r);
    measured.y.push_back(measured_digit(chain, h));
    measured.point_labels.push_back(course::number(measured.y.back(), 2));
  }
  for (int i = 0; i <= 60; ++i) {
    const double r = std::pow(1000, i / 60.0);
    for (renderer::Curve* curve : {&exact, &law}) curve->x.push_back(r);
    exact.y.push_back(textbook_digit(with_heavy_end(knobs.chain(), r)));
    law.y.push_back(std::log(10.0) * r * (n - 1));
  }
  renderer::Chart chart;
  chart.x = {.label = "mass ratio r (end bob/other bob)", .scale = renderer::Scale::logarithmic};
  chart.y = {.label = "sweeps for one more digit", .scale = renderer::Scale::logarithmic};
  chart.curves = {measured, exact, law};
  page.figure(
      "heavy_end",
      say("Sweeps for one more digit against the mass ratio, @ links. Grey: exact; orange: the law for r ≫ N.", n),
      chart);

  HeldStep sweep(heavy, h), direct(heavy, h, Direct{});
  constexpr int few = 10;
  for (int i = 0; i < few; ++i) sweep.solve_sweep();
  direct.solve();
  page.text(
      R"(After @ sweeps the top joint carries the share @ of the weight; after a direct solve of the same rows, @.)",
      few, sweep.shares().front(), direct.shares().front());
  page.claim("sweeps for one more digit, heavy end", heavy_digit, "1",
             is(textbook_digit(heavy), "largest eigenvalue of D⁻¹A, dense", relative(1e-4)));
  page.claim("law for a very heavy end", heavy_digit, "1",
             is(std::log(10.0) * ratio * (n - 1), "ρ ≈ 1 − 1/(r(N − 1))", relative(n / ratio)),
             Quantity("r", ratio) >= Quantity("5N", 5 * n));
  page.claim("two links: convergence factor of a sweep",
             measured_factor(GaussSeidel{.warm_start = false}, with_heavy_end(knobs.chain(2), ratio), h), "1",
             is(ratio / (1 + ratio), "r/(1 + r)", relative(1e-6)));
  page.claim("direct solve: share at the top joint", direct.shares().front(), "1",
             is(1, "all the weight hangs there", relative(1e-9)));
}

}  // namespace byhand::iterations
