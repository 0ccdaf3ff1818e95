// Deeper: a rod that slides on its tip, where friction's bound makes the two rows contradict each other.

#include <Eigen/LU>

#include "lessons/05_contact/steps.hpp"
#include "lessons/scenes/rod.hpp"
#include "solver/constraints/contact.hpp"
#include "solver/constraints/friction.hpp"

namespace byhand::contact {
namespace {

constexpr double steep = 2;  // tanθ of the rod that is looked at closely
constexpr int most_sweeps = 400;

/// A = JM⁻¹Jᵀ of the normal (0) and the tangent (1) at the lower tip of a rod of 1 m, inclined at θ to the right
/// [1/kg].
Eigen::Matrix2d at_the_tip(double angle, double mass) {
  const PlaneRod rod({0, 0}, {std::cos(angle), std::sin(angle)}, mass);
  Scene<PlaneBody> scene;
  const int ground = scene.add_body(Pose<PlaneBody>(), fixed<PlaneBody>()),
            body = scene.add_body(rod.pose, rod.mass);
  const auto& pose = scene.bodies().pose;
  const Contact<PlaneBody> contact{between<PlaneBody>(scene.bodies(), ground, {0, 0}, body, {0, 0})};
  Eigen::Matrix<double, 2, 6> J;
  J.row(0) = contact.jacobian(pose[0], pose[1]).matrix;
  // To the right, whichever way the tangent of the solver points.
  const auto tangent =
      Friction<PlaneBody>{contact.at, tangents_of<PlaneBody>(contact.normal)}.jacobian(pose[0], pose[1]);
  J.row(1) = (tangent.matrix(3) > 0 ? 1 : -1) * tangent.matrix;
  Eigen::Matrix<double, 6, 1> over_mass = Eigen::Matrix<double, 6, 1>::Zero();
  over_mass.tail<3>() << rod.mass.linear, rod.mass.linear, rod.mass.angular[0];
  return J * over_mass.asDiagonal() * J.transpose();
}

/// By how much λₙ = 1 lifts the tip while it slides to the left and friction, at its bound, pushes to the right
/// [1/kg].
double lift(double angle, double friction, double mass) {
  const Eigen::Matrix2d A = at_the_tip(angle, mass);
  return A(0, 0) + friction * A(0, 1);
}

/// The μ from which on that is negative [1].
double critical(double angle) {
  const Eigen::Matrix2d A = at_the_tip(angle, 1);
  return -A(0, 0) / A(0, 1);
}

/// What sweeps make of the two rows within one step.
struct Swept {
  Eigen::Vector2d lambda = Eigen::Vector2d::Zero(), rate;  // of the normal and the tangent [N s], [m/s]
  int sweeps = 0;                                          // until nothing changes any more
};

Swept swept(const Eigen::Matrix2d& A, const Eigen::Vector2d& rate, double friction) {
  Swept swept{.rate = rate};
  const auto solve = [&](int row, double lower, double upper) {
    const double wanted = swept.lambda[row] - swept.rate[row] / A(row, row);
    const double change = std::clamp(wanted, lower, upper) - swept.lambda[row];
    swept.lambda[row] += change;
    swept.rate += change * A.col(row);
    return std::abs(change);
  };
  for (double change = INFINITY; swept.sweeps < most_sweeps && change > 1e-13 * swept.lambda.norm();
       ++swept.sweeps) {
    change = solve(0, 0, INFINITY);
    const double bound = friction * swept.lambda[0];
    change += solve(1, -bound, bound);
  }
  return swept;
}

}  // namespace

void no_answer(const Setting& setting, Page& page) {
  const double mass = setting.mass, h = setting.h(), angle = std::atan(steep), mu = critical(angle);
  page.text(
      R"(The bound of friction's row is another row's λ. Such a problem may have one answer, several, or none, as Painlevé
      found in 1895. Let a rod slide on its lower tip to the left, leaning to the right at an angle θ to the ground:
      the tip leads. Friction
      pushes the tip to the right, turns the rod, and so drives the tip into the ground.)");
  page.formula("a unit of λₙ speeds the tip upwards by A_nn − μ|A_nt| = (1 + 3cos²θ − 3μ sinθ cosθ)/m",
               R"(\text{lift per unit of } \lambda_n{:}\quad A_{nn} - \mu\,|A_{nt}|
         = \frac{1 + 3\cos^2\theta - 3\mu\sin\theta\cos\theta}{m})");
  page.predict(
      {.ask = say("tanθ = @. What is the smallest μ at which the ground's push no longer lifts the tip?", steep),
       .answer = mu,
       .unit = "1",
       .tolerance = 0.04,
       .wrong = {{steep, "At μ = tanθ a box on a slope begins to slide; here the rod slides already."},
                 {1 / steep, "That is μ = 1/tanθ: the push then passes through the centre and turns nothing."}},
       .hints = {"How much does λₙ lift the tip by itself, and how much does μλₙ sink it?",
                 "1 + 3cos²θ = 3μ sinθ cosθ.", "(1 + 3 · 0.2)/(3 · 0.4) = …"},
       .right = "4/3; every other angle needs more. Rubber reaches that."});
  Chart chart{.x = {.label = "θ from level (°)"}, .y = {.label = "lift of the tip per unit of λₙ, times m"}};
  for (const double friction : {0.5, 1.0, 4.0 / 3, 2.0}) {
    Curve curve{.label = say("μ = @", Value(friction, 3))};
    for (int degree = 2; degree <= 88; degree += 2) {
      curve.x.push_back(degree);
      curve.y.push_back(lift(radians(degree), friction, 1));
    }
    chart.curves.push_back(std::move(curve));
  }
  chart.references.push_back({.value = 0, .label = "below: pressing drives the tip down"});
  page.figure("lift_of_the_tip",
              "How the ground's push moves the tip of a rod that slides, tip first. Below zero a harder push "
              "brings the tip down faster.",
              chart);

  // It slides at the lesson's speed when gravity has acted for a step.
  const double friction = 1.5 * mu;
  const Eigen::Matrix2d A = at_the_tip(angle, mass);
  const Eigen::Vector2d rate(-gravity * h, -setting.speed);
  const Swept end = swept(A, rate, friction);
  const Eigen::Vector2d sticking = -A.inverse() * rate;
  const Quantity beside_weight("λₙ/mgh", end.lambda[0] / (mass * gravity * h)),
      slip("slip left/speed", std::abs(end.rate[1]) / setting.speed);
  page.text(
      R"(Below zero no force holds the tip while it slides. A step still has an answer, because it deals in impulses. With
      μ = @ each sweep makes λₙ up to @ times larger. @ Chalk that hops over a blackboard does this.)",
      Value(friction, 3), Value(friction / mu, 3),
      page.verdict(
          {{.when = where(slip<1e-6, beside_weight> 1),
            .say = say(R"(This ends after @, when friction has stopped the tip: λₙ is then @ N·s, @ times mgh,
                                an impact without a collision.)",
                       several(end.sweeps, "sweep"), Value(end.lambda[0], 3), Value(beside_weight.value, 3))}}));

  double least = INFINITY;
  for (double at = 0.01; at < 0.5 * pi; at += 1e-3) least = std::min(least, critical(at));
  page.claim("least μ with which pressing lowers the tip, of all angles", least, "1",
             is(4.0 / 3, "the least of (1 + 3cos²θ)/(3 sinθ cosθ)", relative(1e-6)));
  page.claim("λₙ at the end of the sweeps", end.lambda[0], "N s",
             is(sticking[0], "both rates are zero: (17) for both rows as a block", relative(1e-9)));
  page.claim("slip at the end of the sweeps", end.rate[1], "m/s",
             is(0, "friction has stopped it", absolute(1e-9 * setting.speed)));
}

}  // namespace byhand::contact
