#include "lessons/02_single_constraint/steps.hpp"

namespace byhand::single_constraint {
namespace {

/// Kinetic energy of the scene after an impulse λ along its row [J].
double energy_after(const Pendulum& scene, const OneRow& row, double lambda) {
  Bodies<PlaneParticle> bodies = scene.bodies();
  std::tie(bodies.velocity[0], bodies.velocity[1]) = row.velocities_after(lambda);
  return kinetic_energy(bodies);
}

/// All (u₁, u₂) whose change from `before` costs as much as that of `through`: an ellipse in the mass metric.
Curve equal_cost(const Eigen::Vector2d& before, const Eigen::Vector2d& through, double m1, double m2) {
  const Eigen::Vector2d change = through - before;
  const double cost = m1 * change.x() * change.x() + m2 * change.y() * change.y();
  Curve ellipse{.label = "", .colour = fade(palette::force, 0.6)};
  for (int i = 0; i <= 180; ++i) {
    const auto [sin, cos] = sin_cos(radians(2 * i));
    ellipse.x.push_back(before.x() + std::sqrt(cost / m1) * cos);
    ellipse.y.push_back(before.y() + std::sqrt(cost / m2) * sin);
  }
  return ellipse;
}

}  // namespace

void least_change(const Setting& setting, Page& page) {
  const Pendulum scene = let_go(setting);
  const OneRow row(scene);
  const double gain = gravity() * setting.h(), unit = setting.mass() * gain / setting.length();
  const auto energy = [&](double lambda) { return energy_after(scene, row, lambda); };

  page.text(
      R"(We found (17) by asking for JV = 0. Ask instead which impulse λ along the row leaves the least kinetic energy.
      The kinetic energy is a parabola in λ with slope JV at λ = 0 and curvature JM⁻¹Jᵀ, so its lowest point is (17)
      again.)");
  page.derivation("The least kinetic energy",
                  {{"V becomes V + M⁻¹Jᵀλ", "T(λ) = ½(V + M⁻¹Jᵀλ)·M(V + M⁻¹Jᵀλ)",
                    R"(T(\lambda) = \tfrac12 (V + M^{-1}J^T\lambda)\cdot M(V + M^{-1}J^T\lambda))"},
                   {"multiply out", "T(λ) = T(0) + λJV + ½λ²JM⁻¹Jᵀ",
                    R"(T(\lambda) = T(0) + \lambda JV + \tfrac12\lambda^2 JM^{-1}J^T)"},
                   {"dT/dλ = 0", "λ = −JV/(JM⁻¹Jᵀ)", R"(\lambda = -JV/(JM^{-1}J^T))"}});
  Curve parabola{.label = "", .colour = palette::series(5)};
  for (int i = 0; i <= 80; ++i) {
    parabola.x.push_back(unit * (-2 + 3.0 * i / 80));
    parabola.y.push_back(energy(parabola.x.back()));
  }
  const double rate = shown_row(setting).JV, rest = energy(0);
  const Curve tangent{.label = "slope JV",
                      .x = {-0.5 * unit, 0.5 * unit},
                      .y = {rest - 0.5 * unit * rate, rest + 0.5 * unit * rate},
                      .colour = palette::constraint};
  std::vector<renderer::Annotation> dots{
      {shown_row(setting).lambda, course::without_rounding(energy(row.lambda), energy(unit) + energy(-unit)),
       "λ of (17)"}};
  if (rate != 0) dots.push_back({0, rest, "no impulse"});
  page.figure(
      "parabola",
      say("Kinetic energy after an impulse λ along the row. λ of (17) is @ N·s/m.", shown_row(setting).lambda),
      Chart{.x = {.label = "λ (N·s/m)"},
            .y = {.label = "kinetic energy (J)"},
            .curves = {parabola, tangent},
            .annotations = dots});
  const double left = energy(-unit), middle = energy(0), right = energy(unit);
  // Along the rod alone, two free bobs are two numbers u1, u2, and JV = 0 says that they are equal.
  page.claim("λ that minimises the kinetic energy", unit * (left - right) / (2 * (left - 2 * middle + right)),
             "N·s/m", is(row.lambda, "(17)", absolute(1e-13 * unit)));
  const double m1 = setting.mass(), m2 = 4 * m1, speed = std::sqrt(gravity() * setting.length());
  const Vector along = from_straight_down<PlaneParticle>(radians(setting.angle()));
  const Pendulum pair = two_free_bobs(setting, speed * along);
  const auto [v1, v2] = OneRow(pair).velocities_after();
  const Eigen::Vector2d before(speed, 0), solved(along.dot(v1), along.dot(v2));
  const auto cost = [&](const Eigen::Vector2d& u) {
    return 0.5 * m1 * (u.x() - before.x()) * (u.x() - before.x()) +
           0.5 * m2 * (u.y() - before.y()) * (u.y() - before.y());
  };
  const Eigen::Vector2d only1(0, 0), only2(speed, speed);
  page.text(
      R"(But why push along Jᵀ at all? Other impulses make JV = 0 as well. Take two free bobs, @ kg and @ kg; the first
      moves at @ m/s along the rod towards the second. Stopping the first alone makes JV = 0, and so does speeding up
      the second alone. Measure each change by ½ΔV·MΔV:

      - push the first alone: @ J
      - push the second alone: @ J
      - push both, by M⁻¹Jᵀλ: @ J)",
      m1, m2, speed, cost(only1), cost(only2), cost(solved));
  Curve rule{.label = "JV = 0",
             .x = {-0.1 * speed, 1.2 * speed},
             .y = {-0.1 * speed, 1.2 * speed},
             .colour = palette::constraint};
  page.figure(
      "least_change",
      R"(u₁, u₂: the bobs' velocities along the rod. On the line JV = 0; on each ellipse ½ΔV·MΔV is constant. The smallest ellipse that
      reaches the line touches it at the solver's answer, the only one that keeps the momentum.)",
      Chart{.x = {.label = "u₁ (m/s)", .range = std::pair{-0.55 * speed, 2.25 * speed}},
            .y = {.label = "u₂ (m/s)", .range = std::pair{-0.6 * speed, 1.15 * speed}},
            .curves = {rule, equal_cost(before, solved, m1, m2), equal_cost(before, only1, m1, m2)},
            .annotations = {{before.x(), before.y(), "V before"},
                            {solved.x(), solved.y(), "V after (20)"},
                            {only1.x(), only1.y(), "first alone"},
                            {only2.x(), only2.y(), "second alone"}}});
  double least = cost(only1);
  for (int i = 0; i <= 10000; ++i) least = std::min(least, cost(Eigen::Vector2d::Constant(speed * i / 10000)));
  page.claim("change of V by (20), in the mass metric", cost(solved), "J",
             is(0.5 * m1 * m2 / (m1 + m2) * speed * speed, "½·E·(JV)², E the effective mass", relative(1e-12)));
  page.claim("the same, against every other way to JV = 0", cost(solved), "J",
             is_at_most(least * (1 + 1e-12), "the least of 10,000 points on the line"));
}

}  // namespace byhand::single_constraint
