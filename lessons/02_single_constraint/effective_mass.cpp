#include "lessons/02_single_constraint/plain.hpp"
#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {
namespace {

using Row4 = Eigen::RowVector4d;
using Matrix4 = Eigen::Matrix4d;

/// The matrix that the article asks not to build, built here once to be compared with: diag(m₁⁻¹, m₁⁻¹, m₂⁻¹,
/// m₂⁻¹).
Matrix4 inverse_mass_matrix(const Pendulum& scene) {
  const double m1 = scene.bodies().inverse_mass[0].linear, m2 = scene.bodies().inverse_mass[1].linear;
  return Eigen::Vector4d(m1, m1, m2, m2).asDiagonal();
}

/// A matrix as square cells of a side with their numbers; zeros are pale. Returns the right edge.
double draw_matrix(Canvas& canvas, const Eigen::MatrixXd& matrix, double cell, double x, double middle,
                   const Colour& colour, const std::string& name) {
  const double top = middle + cell * matrix.rows() / 2;
  for (int i = 0; i < matrix.rows(); ++i)
    for (int j = 0; j < matrix.cols(); ++j) {
      const Rectangle box{x + j * cell, top - (i + 1) * cell, cell, cell};
      const bool zero = matrix(i, j) == 0;
      canvas.rectangle(box, {zero ? palette::paper : fade(colour, 0.25), {palette::grid, 1.5}});
      canvas.text(box.centre(), course::number(matrix(i, j), 3),
                  {.size = std::min(22.0, 0.27 * cell), .colour = zero ? palette::muted : palette::ink});
    }
  const double right = x + cell * matrix.cols();
  canvas.text({(x + right) / 2, top + 16}, name,
              {.size = 24, .colour = colour, .anchor = Anchor::bottom, .bold = true});
  return right;
}

void draw_product(Canvas& canvas, const Row4& J, const Matrix4& inverse_mass, double K) {
  // On a narrow page J is above M⁻¹, and the result below it.
  const bool narrow = canvas.page().is_high();
  const double cell = narrow ? 78 : 88, left = 40, middle = narrow ? 340 : 400, gap = narrow ? 30 : 44;
  double x = draw_matrix(canvas, J, cell, left, narrow ? 620 : middle, palette::constraint, "J") + gap;
  if (narrow) x = left;
  const std::array ways{"v₁ₓ", "v₁ᵧ", "v₂ₓ", "v₂ᵧ"};
  for (int i = 0; i < 4; ++i)
    canvas.text({x - 6, middle + cell * (1.5 - i)}, ways[static_cast<std::size_t>(i)],
                {.size = 18, .colour = palette::muted, .anchor = Anchor::right});
  x = draw_matrix(canvas, inverse_mass, cell, x, middle, palette::force, "M⁻¹") + gap;
  x = draw_matrix(canvas, J.transpose(), cell, x, middle, palette::constraint, "Jᵀ") + gap;
  canvas.text(narrow ? Point(left, 130) : Point(x, middle), say("= @ m²/kg", K),
              {.size = 26, .anchor = Anchor::left, .bold = true});
  const auto zeros = (inverse_mass.array() == 0).count();
  canvas.text(
      {canvas.page().centre().x(), narrow ? 70 : 130},
      say("@ of the @ numbers of M⁻¹ are zero. Only m₂⁻¹ is left, written twice.", zeros, inverse_mass.size()),
      {.size = 22, .colour = palette::muted});
}

}  // namespace

void effective_mass(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row(scene);
  const double length = setting.length(), m1 = scene.bodies().inverse_mass[0].linear,
               m2 = scene.bodies().inverse_mass[1].linear;

  page.text(
      R"(How hard is it to change JV? An impulse λJᵀ changes V by M⁻¹Jᵀλ (impulse over mass), so JV by JM⁻¹Jᵀ·λ. This step
      computes the factor JM⁻¹Jᵀ. M⁻¹ has the bodies' inverse masses on its diagonal:)");
  page.equation(18);
  page.text(
      R"(No program needs this matrix. A particle has one number, m⁻¹; a body that turns has I⁻¹ as well. So a row
      between two bodies needs at most four terms; here nothing turns, and two are left:)");
  page.equation(19, "JM⁻¹Jᵀ = |l₁|²·m₁⁻¹ + |l₂|²·m₂⁻¹ = @·@ + @·@ = @ m²/kg",
                R"(JM^{-1}J^T = |l_1|^2 m_1^{-1} + |l_2|^2 m_2^{-1} = @\cdot @ + @\cdot @ = @\ \mathrm{m^2/kg})",
                row.J.l1().squaredNorm(), m1, row.J.l2().squaredNorm(), m2, row.K);
  page.excerpt("lessons/02_single_constraint/plain.hpp", "19");
  page.text("The solver does the same sum for any J, with W = JM⁻¹ computed once:");
  page.excerpt("solver/row.hpp", "19");

  Row4 J = row.J.matrix;
  const Matrix4 inverse_mass = inverse_mass_matrix(scene);
  const double product = J * inverse_mass * J.transpose();
  page.figure("no_matrix",
              say(R"((19) for two particles in the plane. The fixed point has an inverse mass
          of 0. (19) needs @ multiplications, the product of matrices @.)",
                  2 * (PlaneParticle::linear + 1), 4 * 4 + 4),
              [=](Canvas& canvas) { draw_product(canvas, J, inverse_mass, product); });

  page.text(
      R"(JM⁻¹Jᵀ is an *inverse* mass: heavier bodies make it smaller. 1/(JM⁻¹Jᵀ) = @ kg/m² is the effective mass
      for JV. JV is |d| times the speed along the rod; for that speed the effective mass is |d|²/(JM⁻¹Jᵀ) = @
      kg, the bob's own mass, because nothing else moves.)",
      1 / row.K, length * length / row.K);
  const Pendulum pair = two_free_bobs(setting);
  const double light = setting.mass(), heavy = 4 * light, together = length * length / OneRow(pair).K;
  page.text(
      R"(If both ends of a rod can move, @ kg at one and @ kg at the other, the effective mass along it is @ kg: less
      than the lighter one, because the other end moves too.

      *The article calls M⁻¹ "the mass of the constraint" and JM⁻¹Jᵀ "the constraint mass". The first is the
      inverse mass matrix of the bodies, the second the inverse effective mass.*)",
      light, heavy, together);

  Pendulum twice = scene;
  twice.set_mass(1, with_mass<PlaneParticle>(2 * setting.mass()));
  page.claim("JM⁻¹Jᵀ by the two terms of (19)",
             plain_inverse_effective_mass(row.J.l1().transpose(), m1, row.J.l2().transpose(), m2), "m²/kg",
             is(product, "J, M⁻¹ and Jᵀ multiplied as matrices", relative(1e-14)));
  page.claim("JM⁻¹Jᵀ by the solver", row.K, "m²/kg",
             is(product, "J, M⁻¹ and Jᵀ multiplied as matrices", relative(1e-14)));
  page.claim("JM⁻¹Jᵀ with twice the mass, against once", OneRow(twice).K / row.K, "1",
             is(0.5, "it is an inverse mass", relative(1e-14)));
  page.claim("effective mass of two free bobs along the rod", together, "kg",
             is(light * heavy / (light + heavy), "m₁m₂/(m₁ + m₂)", relative(1e-13)));
}

}  // namespace byhand::single_constraint
