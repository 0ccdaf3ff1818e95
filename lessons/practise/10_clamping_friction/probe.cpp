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
  const double mu = p.number("mu", "1", 0.1, 0.9), normal = p.number("normal", "N s", 0.3, 3);
  // Within the bounds at first; the increment often leads beyond one of them.
  const double given = p.number("accumulated", "N s", -0.9 * mu * normal, 0.9 * mu * normal);
  const double delta = p.number("delta", "N s", -3, 3);
  double accumulated = given;
  const double applied = clamp_friction(accumulated, delta, mu, normal);
  p.answer("applied", "N s", applied);
  p.answer("accumulated", "N s", accumulated);
  p.law("accumulated changes by what is applied", "N s", accumulated, given + applied);

  const Vec2 r = p.vector("r", "m", 0.8);
  Contact c = contact_at(r, p.number("m", "kg", 0.3, 5), p.number("I", "kg m²", 0.1, 3), mu);
  Velocities V;
  V.v2 = {p.number("v.x", "m/s", -3, 3), -p.number("falling", "m/s", 0.3, 3)};
  V.w2 = p.number("w", "rad/s", -1, 1);
  for (int pass = 1; pass <= 3; ++pass) {
    solve_contact(c, V);
    const std::string after = ", pass " + std::to_string(pass);
    p.answer("λ" + after, "N s", Vec2{c.lambda_normal, c.lambda_tangent});
    p.answer("v" + after, "m/s", V.v2);
  }
  const double most = mu * c.lambda_normal;
  p.law("friction is at most μ times the normal impulse", "N s", std::max(most, std::abs(c.lambda_tangent)), most);
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
