// Step 3: the matrix of all rows, its factor and its inverse.

#include <Eigen/Cholesky>

#include "lessons/03_iterations/held_step.hpp"
#include "lessons/03_iterations/knobs.hpp"
#include "lessons/exact/hanging_chain.hpp"
#include "solver/direct/equations.hpp"

namespace byhand::iterations {
namespace {

/// JM⁻¹Jᵀ [m²/kg] from the rows as the solver wrote them; the step must be in natural order.
Eigen::MatrixXd matrix_of(const System<PlaneParticle>& system, int bodies) {
  constexpr int dof = PlaneParticle::dof;
  Eigen::MatrixXd J = Eigen::MatrixXd::Zero(system.rows(), dof * bodies), W = J;
  for (const auto& block : std::get<block_type<PlaneParticle, 1, Bound::none>()>(system.blocks)) {
    J.block<1, dof>(block.row, dof * block.body1) = block.J.side1();
    J.block<1, dof>(block.row, dof * block.body2) = block.J.side2();
    W.block<1, dof>(block.row, dof * block.body1) = block.W.side1();
    W.block<1, dof>(block.row, dof * block.body2) = block.W.side2();
  }
  return J * W.transpose();
}

int nonzeros(const Eigen::MatrixXd& matrix) {
  return static_cast<int>((matrix.array().abs() > 1e-9 * matrix.cwiseAbs().maxCoeff()).count());
}

/// The matrix as a map, cells that are zero left empty.
renderer::Chart map_of(const Eigen::MatrixXd& matrix, std::string title, std::string unit, bool diverging) {
  const auto n = static_cast<int>(matrix.rows());
  renderer::HeatMap map{.label = std::move(unit), .diverging = diverging, .square = true};
  for (int i = 1; i <= n; ++i) {
    map.x.push_back(i);
    map.y.push_back(i);
  }
  for (int i = 0; i < n; ++i)
    for (int j = 0; j < n; ++j)
      map.values.push_back(std::abs(matrix(i, j)) > 1e-9 * matrix.cwiseAbs().maxCoeff() ? matrix(i, j) : NAN);
  if (!diverging) map.range = {0, matrix.maxCoeff()};
  renderer::Chart chart;
  chart.title = std::move(title);
  chart.x.label = "column: joint";
  chart.y.label = "row: joint";
  chart.y.reversed = true;
  for (int i = (n + 4) / 5; i <= n; i += (n + 4) / 5) chart.x.ticks.push_back({double(i), std::to_string(i)});
  chart.y.ticks = chart.x.ticks;
  chart.heat_map = std::move(map);
  return chart;
}

}  // namespace

void all_at_once(Page& page, const Knobs& knobs) {
  const ChainOptions chain = knobs.chain();
  const int n = knobs.links;
  const double m = knobs.mass, L = knobs.length;
  HeldStep held(chain, knobs.h);
  const Eigen::MatrixXd A = matrix_of(held.work().system, held.scene().bodies().size());
  const Eigen::MatrixXd factor = Eigen::LLT<Eigen::MatrixXd>(A).matrixL();
  const Eigen::MatrixXd inverse = A.llt().solve(Eigen::MatrixXd::Identity(n, n));

  page.text(
      R"(We can also solve all rows at once. Each row's impulse changes the JV of every row that shares a body with it.
      Require JV + b = 0 in every row after all impulses together:)");
  page.formula("A λ = −(JV + b),   A = JM⁻¹Jᵀ, @ × @",
               R"(A\,\lambda = -(JV + b), \qquad A = JM^{-1}J^T, \quad @ \times @)", n, n);
  page.derivation("One equation for all rows",
                  {{"all rows of J below each other, all λ in a column: (20)", "V′ = V + M⁻¹Jᵀλ",
                    R"(V' = V + M^{-1}J^T\lambda)"},
                   {"wanted in every row", "JV′ + b = 0", R"(JV' + b = 0)"},
                   {"insert", "JM⁻¹Jᵀ λ = −(JV + b)", R"(JM^{-1}J^T\,\lambda = -(JV + b))"}});
  page.text(
      R"(The diagonal of A holds (19) of each row; the entries beside it say what a joint does to its neighbours through
      the bob that they share. A joint has at most two, so A has at most three nonzero numbers a row, 3N − 2 in all: @ of
      @@. Elimination writes A = RRᵀ, R lower triangular (the *Cholesky factor*), and stores only R.)",
      nonzeros(A), n * n, n >= 6 ? "; A is *sparse*" : " (for long chains A is *sparse*)");
  page.predict({.ask = say("How many numbers of R are not zero, for these @ joints?", n),
                .answer = static_cast<double>(nonzeros(factor)),
                .unit = "1",
                .tolerance = 0.5,
                .wrong = {{0.5 * n * (n + 1), "The triangle has that many places; most stay empty."},
                          {static_cast<double>(n * n), "That is A⁻¹, which nobody needs."},
                          {static_cast<double>(nonzeros(A)), "That is A, on both sides of its diagonal."}},
                .hints = {"Eliminate joint 1. Which entries of A change?",
                          "Only its neighbour's on the diagonal: nothing fills in.",
                          say("The diagonal and the entries below it: @ + @ = …", n, n - 1)},
                .right = "Two a joint, one for the last: R is as sparse as A."});
  page.figure("matrices",
              say(R"(Left: A, with @ nonzero entries. Middle: its factor R, with @. Right: its inverse, with
                  @. Empty cells are zero.)",
                  nonzeros(A), nonzeros(factor), nonzeros(inverse)),
              [=](renderer::Canvas& canvas) {
                const renderer::Rectangle paper = canvas.page();
                const auto cells = paper.inset(16, paper.is_high() ? 16 : 120).grid(1, 3, 18);
                const std::array maps{map_of(A, "A = JM⁻¹Jᵀ", "m²/kg", true),
                                      map_of(factor, "its factor R", "m/√kg", true),
                                      map_of(inverse, "A⁻¹", "kg/m²", false)};
                // All as large as the smallest, whose numbers beside the colours are the longest.
                double side = cells[0].width;
                for (const renderer::Chart& map : maps)
                  side = std::min(side, renderer::layout(canvas, map, cells[0]).width);
                for (std::size_t i = 0; i < maps.size(); ++i) {
                  const double own = renderer::layout(canvas, maps[i], cells[i]).width;
                  draw(canvas, maps[i], {cells[i].x, cells[i].y, cells[i].width - (own - side), cells[i].height});
                }
              });
  page.text(
      R"(A⁻¹ is *full*: every joint's λ depends on every row's error. A column of A⁻¹ says what each joint must do if only
      that one row has an error: every joint above pulls with full strength, each joint below only as hard as the bobs
      under it need. Nobody needs it: R is enough (step 7b counts its cost).

      *The article calls solving all constraints simultaneously "very inefficient". For loops and piles it can be;
      for a chain it is not.*)");

  HeldStep direct(chain, knobs.h, Direct{});
  direct.solve();
  const std::vector<double> masses(static_cast<std::size_t>(n), m);
  const std::vector<double> tensions = hanging_chain_tensions(masses, Knobs::gravity);
  double worst_tension = 0, worst_inverse = 0;
  for (int i = 0; i < n; ++i) {
    worst_tension = std::max(worst_tension, std::abs(direct.shares()[i] * knobs.weight() / tensions[i] - 1));
    for (int j = 0; j < n; ++j)
      worst_inverse = std::max(worst_inverse, std::abs(inverse(i, j) * L * L / (m * (n - std::max(i, j))) - 1));
  }
  page.text("Solved directly, once: the top joint carries @ N, the lowest @ N, and every row's error is @.",
            direct.shares().front() * knobs.weight(), direct.shares().back() * knobs.weight(),
            direct.error() <= 1e-12 * n * knobs.fall() ? std::string("at the level of rounding")
                                                       : say("up to @ gh", direct.error() / knobs.fall()));
  page.claim("largest relative error of the joints' forces", worst_tension, "1",
             is(0, "the weight below each joint", absolute(1e-12 * n)));
  page.claim("largest relative error of A⁻¹, entry by entry", worst_inverse, "1",
             is(0, "(A⁻¹)ᵢⱼ = m (N + 1 − max(i, j)) / L²", absolute(1e-12 * n)));
  page.claim("entries of A that are not zero", static_cast<double>(nonzeros(A)), "1",
             is(3.0 * n - 2, "3N − 2", absolute(0)));
  page.claim(
      "numbers that the direct solve stores",
      static_cast<double>(std::any_cast<const DirectWork<PlaneParticle>&>(direct.work().solver).plan.values), "1",
      is(2.0 * n - 1, "2N − 1: nothing fills in", absolute(0)));
}

}  // namespace byhand::iterations
