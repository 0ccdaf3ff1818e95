#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/01_rod_between_particles/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

void probe(Probe& p, const Code& code) {
  const auto [value, jacobian] = Learners::of(code);
  const Vec2 p1 = p.vector("p1", "m", p.sized(3)), p2 = p.vector("p2", "m", p.sized(3));
  const double L = p.number("L", "m", p.sized(0.3), p.sized(4));
  const Vec2 v1 = p.vector("v1", "m/s", p.sized(2)), v2 = p.vector("v2", "m/s", p.sized(2));

  const double C = value(p1, p2, L);
  p.answer("C", "m²", C);
  const ParticleRow J = jacobian(p1, p2, L);
  p.answer("J.l1", "m", J.l1);
  p.answer("J.l2", "m", J.l2);
  p.law("J is the gradient of C, so JV = dC/dt", "m²/s", dot(J, v1, v2),
        rate_of([&, &C_at = value](double t) { return C_at(p1 + t * v1, p2 + t * v2, L); }));
  p.law("if both move together, JV = 0: l1·v = −l2·v", "m²/s", dot(J.l1, v1), -dot(J.l2, v1));
  p.law("if both are shifted, C stays", "m²", value(p1 + v1, p2 + v1, L), C);
  const Vec2 at_length = p1 + L / length(p2 - p1) * (p2 - p1);
  p.law("at the rod's length, C = 0", "m²", value(p1, at_length, L), 0);
}

void film(Film& film, const Code& code) {
  const auto [value, jacobian] = Learners::of(code);
  film.title = "Two bobs on a rod of 2 m that begins too long";
  film.quantity = "length of the rod";
  film.unit = "m";
  constexpr double L = 2, h = time_step, m1 = 3, m2 = 1;
  Vec2 p1{-0.6, 0}, p2{1.8, 0}, v1{0, -1}, v2{0, 3};
  for (int i = 0; i <= 180; ++i) {
    if (i % 2 == 0)
      film.frames.push_back(
          {{{Shape::rod, p1, p2}, {Shape::bob, p1, {0.2, 0}}, {Shape::bob, p2, {0.14, 0}}}, length(p2 - p1)});
    const ParticleRow J = jacobian(p1, p2, L);
    const Velocities V = solved({J.l1, 0, J.l2, 0}, {v1, 0, v2, 0}, {1 / m1, 0, 1 / m2, 0},
                                rate_that_keeps(value(p1, p2, L), 0.8, h))
                             .V;
    v1 = V.v1;
    v2 = V.v2;
    p1 += h * v1;
    p2 += h * v2;
  }
}
