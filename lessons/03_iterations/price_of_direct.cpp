// Deeper: what the direct solve of a chain costs.

#include <algorithm>

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"

namespace byhand::iterations {
namespace {

using namespace tutor;

struct Price {
  double row_solves, error;  // error in gh
};

Price direct_price(const ChainOptions& chain, const Knobs& knobs) {
  HeldStep step(chain, knobs.h, Direct{});
  step.solve();
  return {static_cast<double>(step.work().row_solves), step.error() / knobs.fall()};
}

renderer::Curve sweeps_of(const ChainOptions& chain, const Knobs& knobs) {
  renderer::Curve curve{.label = say("Gauss–Seidel, N = @", chain.links)};
  for (double sweeps = 1; sweeps < 17 * chain.links * chain.links; sweeps *= 1.15) {
    const int count = static_cast<int>(sweeps);
    curve.x.push_back(static_cast<double>(count) * chain.links);
    curve.y.push_back(error_after(count, GaussSeidel{}, chain, knobs.h) / knobs.fall());
    if (curve.y.back() < 1e-14) break;
  }
  return curve;
}

}  // namespace

void price_of_direct(Page& page, const Knobs& knobs) {
  const int n = knobs.links;
  const Price once = direct_price(knobs.chain(), knobs), twice = direct_price(knobs.chain(2 * n), knobs);
  const double digit_sweeps = error_after(n, GaussSeidel{}, knobs.chain(), knobs.h) / knobs.fall();

  page.text(
      R"("Iterative solvers are fast", says the article. Count. One *row-solve*, (17) and (20) once, multiplies @
      numbers in this model: @ for JV, as many for the impulse. The direct solve eliminates one joint after the
      other, a handful of multiplications each, and walks back:)",
      4 * PlaneParticle::dof, 2 * PlaneParticle::dof);
  page.excerpt("solver/direct/direct.cpp", "factor");
  // J·W of a row itself and with its neighbour, JV and M⁻¹Jᵀλ, each a sum over the degrees of freedom of the
  // bodies.
  const double around = (2.0 + 1 + 2 + 2) * PlaneParticle::dof / (4 * PlaneParticle::dof);
  page.text(
      R"(For @ links this multiplies as much as @ row-solves do, @ sweeps; for @ links as @, still @ sweeps.
      Writing A down before and putting the impulses into V afterwards cost another @. For the price of a few
      sweeps everything is right to the last digit, while @ sweeps from λ = 0 still leave an error of @ gh.)",
      n, once.row_solves, Value(once.row_solves / n, 2), 2 * n, twice.row_solves,
      Value(twice.row_solves / (2 * n), 2), around, n, digit_sweeps);

  renderer::Chart chart;
  chart.x = {.label = "cost (row-solves)", .scale = renderer::Scale::logarithmic};
  chart.y = {.label = "largest error (gh)", .scale = renderer::Scale::logarithmic, .range = {{1e-17, 3}}};
  for (const int links : {n, 2 * n}) {
    chart.curves.push_back(sweeps_of(knobs.chain(links), knobs));
    const Price price = links == n ? once : twice;
    chart.curves.push_back({.label = say("direct, N = @", links),
                            .x = {price.row_solves},
                            .y = {std::max(price.error, 1e-16)},
                            .style = renderer::CurveStyle::markers});
  }
  page.figure("price",
              R"(Error against cost, counted in multiplications. Gauss–Seidel pays for every digit again, and the
              more the longer the chain is; the direct solve pays once (an error of 0 is drawn at 10⁻¹⁶).)",
              chart);
  page.text(
      R"(So why does anyone iterate? Because this is a chain. Rows with bounds (contacts, friction) have no one
      linear system; loops and piles fill the factor; and when a scene changes by a little, a warm sweep is cheap.
      The rule of this course: paths and trees directly, the rest by sweeps.)");
  page.claim({.quantity = "direct solve, A and impulses included, in sweeps",
              .unit = "1",
              .expected = 3,
              .source = "a few: at most",
              .measured = once.row_solves / n + around,
              .tolerance = at_most()});
  page.claim({.quantity = say("cost of @ links over @", 2 * n, n),
              .unit = "1",
              .expected = 2,
              .source = "O(N)",
              .measured = twice.row_solves / once.row_solves,
              .tolerance = relative(2.0 / n)});
  page.claim({.quantity = "error that it leaves",
              .unit = "gh",
              .expected = 0,
              .source = "A λ = −JV",
              .measured = once.error,
              .tolerance = absolute(1e-13 * n)});
}

}  // namespace byhand::iterations
