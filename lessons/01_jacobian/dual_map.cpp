#include "lessons/01_jacobian/picture.hpp"
#include "lessons/scenes/pendulum.hpp"
#include "solver/constraints/normalised_distance.hpp"

// (5): Jᵀ takes λ to a force. It is J's dual, not its inverse.
namespace byhand::lesson01 {
namespace {

struct Rod {
  Scene<PlaneParticle> scene;
  Jacobian<PlaneParticle, 1> J, W;
  double inverse_mass;  // (19)
};

Rod rod_of(const Settings& set) {
  Rod rod{pendulum<PlaneParticle, NormalisedDistance>(0.6, set.length, set.mass), {}, {}, 0};
  const auto& bodies = rod.scene.bodies();
  rod.J = rod.scene.all<NormalisedDistance>()[0].jacobian(bodies.pose[0], bodies.pose[1]);
  rod.W =
      times_inverse_mass(rod.J, bodies.inverse_mass[0], bodies.pose[0], bodies.inverse_mass[1], bodies.pose[1]);
  rod.inverse_mass = inverse_effective_mass(rod.J, rod.W)(0, 0);
  return rod;
}

/// How far the power of a pull of λ = −1 N by its force may lie from λ·JV, over all directions of a bob that moves
/// at 1 m/s [W].
double largest_difference_of_power(const Jacobian<PlaneParticle, 1>& J) {
  double largest = 0;
  const Linear<PlaneParticle> force = -J.l2().transpose();
  for (int degrees = 0; degrees <= 360; degrees += 6) {
    const double at = degrees * std::numbers::pi / 180;
    const Linear<PlaneParticle> along = J.l2().transpose(), across(-along.y(), along.x());
    const Velocity<PlaneParticle> V = std::cos(at) * along + std::sin(at) * across;
    largest = std::max(largest, std::abs(force.dot(V) + dot(J, Velocity<PlaneParticle>(0, 0), V)[0]));
  }
  return largest;
}

void draw_force(renderer::Canvas& canvas, const Jacobian<PlaneParticle, 1>& J, double length) {
  const Point n = J.l2().transpose(), along(-n.y(), n.x()), bob = length * n;
  const bool narrow = canvas.page().is_high();
  canvas.look(renderer::fit({-0.75 * length, -1.5 * length, 2.4 * length, 1.7 * length}, canvas.page(1.05), 16));
  std::vector<Point> circle;
  for (int i = 0; i <= 60; ++i) circle.push_back(length * from_straight_down<PlaneParticle>(-0.6 + 2.2 * i / 60));
  canvas.path(circle, {palette::theory, 1.6, renderer::Dash::dashed});
  canvas.anchor({0, 0});
  canvas.rod({0, 0}, bob, {renderer::fade(palette::constraint, 0.35), {palette::ink, 0}});
  canvas.hinge({0, 0});
  canvas.disc(bob, 15 / canvas.camera().scale);
  canvas.arrow(bob, bob - 0.45 * length * n, {palette::force, 4});
  canvas.arrow(bob, bob + 0.35 * length * n, {palette::constraint, 4});
  canvas.arrow(bob, bob + 0.5 * length * along, {palette::velocity, 4});
  renderer::TextStyle style{.size = 20, .anchor = renderer::Anchor::left, .halo = 3, .offset = {10, 0}};
  renderer::TextStyle before = style;
  before.colour = palette::force;
  before.anchor = renderer::Anchor::right;
  before.offset = {-14, 0};
  canvas.text(bob - 0.3 * length * n, "F = λJ^T, λ < 0", before);
  style.colour = palette::constraint;
  canvas.text(bob + 0.35 * length * n, "J", style);
  if (narrow) style.anchor = renderer::Anchor::bottom, style.offset = {0, 24};
  style.colour = palette::velocity;
  canvas.text(bob + 0.5 * length * along, "V that the rod allows: JV = 0", style);
}

}  // namespace

void dual_map(course::Page& page, const Settings& set) {
  const Rod rod = rod_of(set);
  const Jacobian<PlaneParticle, 1>& J = rod.J;
  const double JJt = (J.matrix * J.matrix.transpose())(0, 0);
  page.text(
      R"(J takes velocities to a rate of C; (5) takes λ back to forces on the bodies, by the transpose. Is that the
      inverse of J, as the article says? A row has no inverse: JV = 0 on a whole hyperplane of V, so J keeps one
      component and forgets the rest. And Jᵀ does not undo even that one. Take the row of |d| − L between two
      particles and ask for Ċ = 1 with V = Jᵀ·1: Ċ is JJᵀ = @. (With (14) it would be 2|d|², in square metres; where
      bodies turn, square metres would be added to metres to the fourth power.))",
      JJt);
  page.text(
      R"(Jᵀ is the *dual* of J, as with a lever: the factor that multiplies a speed divides a force, so that the power
      is the same on both sides, (λJᵀ)·V = λ(JV) for every V. This is why constraint forces point along J: they do no
      work in a motion that the constraint allows, where JV = 0. A rod neither drives nor brakes its bob.)");
  page.figure("dual", "The rod's force is perpendicular to every motion that the rod allows.",
              [J, length = set.length()](renderer::Canvas& canvas) { draw_force(canvas, J, length); });
  const double back = (J.matrix * rod.W.matrix.transpose())(0, 0) / rod.inverse_mass;
  page.text(
      R"(M⁻¹Jᵀ(JM⁻¹Jᵀ)⁻¹ does lead from a wanted Ċ to velocities: it gives the V with the least kinetic energy of all
      that have this Ċ, and J times it is @. It needs the masses. (17) and (20) of lesson 2 do this together.)",
      back);

  const Linear<PlaneParticle> n = J.l2().transpose();
  const Velocity<PlaneParticle> allowed(-n.y() * set.speed, n.x() * set.speed);
  page.claim("JJᵀ of a unit row between two particles", JJt, "1", is(2, "n·n + n·n", course::absolute(1e-14)));
  page.claim("F·V along the circle at λ = 1 N", n.dot(allowed), "W",
             is(0, "the tangent is perpendicular to the rod", course::absolute(1e-15 * set.speed)));
  page.claim("F·V − λ·JV over all directions, largest", largest_difference_of_power(J), "W",
             is(1e-15, "Jᵀ is the dual map", course::at_most()));
  page.claim("J·M⁻¹Jᵀ(JM⁻¹Jᵀ)⁻¹", back, "1", is(1, "a right inverse", course::absolute(1e-15)));
}

}  // namespace byhand::lesson01
