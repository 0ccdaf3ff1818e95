// Deeper: what the direct solve of a chain costs.

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/03_iterations/plain.hpp"
#include "lessons/03_iterations/textbook.hpp"
#include "solver/direct/equations.hpp"

namespace byhand::iterations {
namespace {

struct Price {
  double row_solves, error;  // without A and the impulses; [gh]
};

constexpr int multiplications_of_a_row = 4 * PlaneParticle::dof;  // (17) and (20) once

Price direct_price(const ChainOptions& chain, const Knobs& knobs) {
  HeldStep step(chain, knobs.h, Direct{});
  step.solve();
  const auto& plan = std::any_cast<const DirectWork<PlaneParticle>&>(step.work().solver).plan;
  return {static_cast<double>(plan.multiplications) / multiplications_of_a_row, step.error() / knobs.fall()};
}

renderer::Curve sweeps_of(const ChainOptions& chain, const Knobs& knobs) {
  renderer::Curve curve{.label = say("Gauss–Seidel, N = @", chain.links)};
  for (double sweeps = 1; sweeps < 17 * chain.links * chain.links; sweeps *= 1.15) {
    const int count = static_cast<int>(sweeps);
    curve.x.push_back(static_cast<double>(count) * chain.links);
    curve.y.push_back(error_after(count, GaussSeidel{}, chain, knobs.h) / knobs.fall());
    if (curve.y.back() < 1e-12) break;
  }
  return curve;
}

}  // namespace

void price_of_direct(Page& page, const Knobs& knobs) {
  const int n = knobs.links;
  const Price once = direct_price(knobs.chain(), knobs), twice = direct_price(knobs.chain(2 * n), knobs);
  const double after_n = error_after(n, GaussSeidel{}, knobs.chain(), knobs.h) / knobs.fall();

  page.text(
      R"(What do the two ways cost? One *row-solve*, (17) and (20) once, takes @ multiplications in this model: @ for JV
      and as many for the impulse. The direct solve eliminates one joint after another, a few multiplications each,
      then substitutes back. For a chain, where A is zero except on its diagonal and beside it:)",
      multiplications_of_a_row, 2 * PlaneParticle::dof);
  page.excerpt("lessons/03_iterations/plain.cpp", "elimination");
  // J·W of a row itself and with its neighbour, JV and M⁻¹Jᵀλ, each a sum over the degrees of freedom of the
  // bodies.
  const double around = (2.0 + 1 + 2 + 2) * PlaneParticle::dof / multiplications_of_a_row;
  page.text(
      R"((The solver's `eliminate` in solver/direct/direct.cpp does this for any graph of bodies, with blocks for
      numbers.) Elimination takes six multiplications a joint (one more than the code above, as it inverts each pivot), a row-solve
      eight: @ sweeps for @ links, @ for @. Setting up A and applying the impulses cost
      another @. Then every row is right to within rounding error, while N = @ from λ = 0 leave an error of @ gh.

      *The article says "iterative solvers are fast". One sweep is; the sweeps that a long chain needs are not.*)",
      Value(once.row_solves / n, 3), n, Value(twice.row_solves / (2 * n), 3), 2 * n, around, several(n, "sweep"),
      Value(after_n, 2));

  constexpr double lowest = 1e-15;  // where rounding is drawn
  renderer::Chart chart;
  chart.x = {.label = "cost (row-solves)", .scale = renderer::Scale::logarithmic};
  chart.y = {.label = "largest error (gh)", .scale = renderer::Scale::logarithmic, .range = {{lowest / 2, 3}}};

  for (const int links : {n, 2 * n}) {
    chart.curves.push_back(sweeps_of(knobs.chain(links), knobs));
    chart.curves.back().colour = renderer::palette::series(links == n ? 0 : 2);
    const Price price = links == n ? once : twice;
    chart.curves.push_back({.label = say("direct, N = @", links),
                            .x = {price.row_solves + around * links},
                            .y = {std::max(price.error, lowest)},
                            .style = renderer::CurveStyle::markers,
                            .place = pictures::place_of("direct")});
  }
  page.figure(
      "price",
      R"(Error against cost (direct: with A and the impulses). Gauss–Seidel pays for every digit, more on a longer chain;
              the direct solve pays once (its rounding error is drawn at 10⁻¹⁵ or above).)",
      chart);
  page.text(
      R"(Why then does anyone iterate? Because not everything is a chain. Rows with bounds (contacts, friction) are not one
      linear system; loops and piles make the factor dense; and where a scene changes little from step to step, a few
      warm sweeps are enough. The rule of this course: paths and trees directly, the rest by sweeps.)");
  HeldStep direct(knobs.chain(), knobs.h, Direct{});
  direct.solve();
  const Eigen::MatrixXd A = textbook_matrix(knobs.chain()) * knobs.length * knobs.length;
  std::vector<double> diagonal, beside, rate(static_cast<std::size_t>(n), 0.0);
  for (int i = 0; i < n; ++i) diagonal.push_back(A(i, i));
  for (int i = 1; i < n; ++i) beside.push_back(A(i, i - 1));
  rate.front() = -knobs.length * knobs.fall();
  const std::vector<double> plain = plain_elimination(diagonal, beside, rate), solved = direct.lambda();
  double apart = 0;
  for (int i = 0; i < n; ++i) apart = std::max(apart, std::abs(plain[i] / solved[i] - 1));
  page.claim("the plain elimination against the solver, relative", apart, "1",
             is_at_most(1e-13 * n * n, "the same λ: rounding"));
  page.claim("direct solve, A and impulses included, in sweeps", once.row_solves / n + around, "1",
             is_at_most(3, "a few sweeps (upper bound)"));
  page.claim("multiplications of an elimination", once.row_solves * multiplications_of_a_row, "1",
             is(6 * n - 4, "six a joint, four fewer at the end", absolute(0)));
  page.claim("error that it leaves", once.error, "gh", is(0, "A λ = −JV", absolute(1e-13 * n)));
}

}  // namespace byhand::iterations
