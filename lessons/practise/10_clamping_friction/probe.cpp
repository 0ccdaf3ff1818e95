#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/10_clamping_friction/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

/// Of body 2 on the ground: the contact point lies at r from its centre.
Contact contact_at(Vec2 r, double mass, double inertia, double mu) {
  Contact c;
  const InverseMasses masses{0, 0, 1 / mass, 1 / inertia};
  const auto row = [&](Vec2 along, BodyRow& J, BodyRow& W, double& K) {
    J = {-along, 0, along, dot(along, cross(1.0, r))};
    W = over_masses(J, masses);
    K = inverse_mass_along(J, masses);
  };
  row({0, 1}, c.J_normal, c.W_normal, c.K_normal);
  row({1, 0}, c.J_tangent, c.W_tangent, c.K_tangent);
  c.mu = mu;
  return c;
}

void probe(Probe& p, const Code& code) {
  const auto [clamp_friction, solve_contact] = Learners::of(code);
  const double mu = p.number("mu", "1", 0.1, 0.9), normal = p.number("normal", "N s", p.sized(0.3), p.sized(3));
  const double bound = mu * normal;
  const double given = p.number("accumulated", "N s", -0.9 * bound, 0.9 * bound);
  // The sum stays within its bounds, exceeds the upper one, or the lower one.
  const double least[] = {-0.9 * bound - given, 1.1 * bound - given, -p.sized(5)},
               most[] = {0.9 * bound - given, p.sized(5), -1.1 * bound - given};
  const double delta = p.number("delta", "N s", least[p.one_of(3)], most[p.one_of(3)]);
  double accumulated = given;
  const double applied = clamp_friction(accumulated, delta, mu, normal);
  p.answer("applied", "N s", applied);
  p.answer("accumulated", "N s", accumulated);
  p.law("accumulated changes by what is applied", "N s", accumulated, given + applied);

  const Vec2 r = p.vector("r", "m", 0.8);
  // One after the other: the order in which arguments of a call are evaluated is the compiler's choice.
  const double mass = p.number("m", "kg", 0.3, 5);
  const double inertia = p.number("I", "kg m²", 0.1, 3);
  Contact c = contact_at(r, mass, inertia, mu);
  // The body falls or separates, and slides either way, with and without impulses from before.
  const bool separates = p.one_of(6) >= 3;
  const double slides = p.one_of(2) == 0 ? 1 : -1;
  if (p.one_of(4) >= 2) {
    c.lambda_normal = p.number("lambda_normal", "N s", 0.3, 3);
    c.lambda_tangent = p.number("lambda_tangent", "N s", -0.9 * mu * c.lambda_normal, 0.9 * mu * c.lambda_normal);
  }
  Velocities V;
  V.v2.x = slides * p.number("slides", "m/s", 0.3, 3);
  V.v2.y = (separates ? 1 : -1) * p.number(separates ? "separates" : "falls", "m/s", 0.3, 3);
  V.w2 = p.number("w", "rad/s", -1, 1);
  for (int pass = 1; pass <= 3; ++pass) {
    solve_contact(c, V);
    const std::string after = ", pass " + std::to_string(pass);
    p.answer("λ" + after, "N s", Vec2{c.lambda_normal, c.lambda_tangent});
    p.answer("v" + after, "m/s", V.v2);
    p.answer("w" + after, "rad/s", V.w2);
  }
  const double limit = mu * c.lambda_normal;
  p.law("friction is at most μ times the normal impulse", "N s", std::max(limit, std::abs(c.lambda_tangent)),
        limit);
}

void film(Film& film, const Code& code) {
  const auto solve_contact = std::get<1>(Learners::of(code));
  film.title = "Box kicked up a slope of 20°, μ = 0.5";
  film.quantity = "centre above the ground";
  film.unit = "mm";
  const double mass = 2, side = 0.6, slope = 20 * std::acos(-1.0) / 180;
  const Body box{
      .at = {-0.8, side / 2}, .v = {3, 0}, .mass = mass, .inertia = mass * side * side / 6, .sides = {side, side}};
  const Vec2 gravity{-9.81 * std::sin(slope), -9.81 * std::cos(slope)};
  box_on_ground(film, box, gravity, slope, [&](Body& of, std::vector<GroundContact>& points, double) {
    std::vector<Contact> contacts;
    for (const GroundContact& point : points)
      if (point.C < 0.005) contacts.push_back(contact_at(point.r, of.mass, of.inertia, 0.5));
    Velocities V{{}, 0, of.v, of.w};
    for (int pass = 0; pass < 10; ++pass)
      for (Contact& contact : contacts) solve_contact(contact, V);
    of.v = V.v2;
    of.w = V.w2;
  });
}
