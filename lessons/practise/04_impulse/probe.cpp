#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/04_impulse/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

void probe(Probe& p, const Code& code) {
  const auto [impulse] = Learners::of(code);
  const BodyRow J = p.row("J");
  const Velocities V = p.velocities("V", p.sized(4));
  const double b = p.number("b", "m²/s", -p.sized(3), p.sized(3));
  const InverseMasses W = p.inverse_masses();
  const double K = inverse_mass_along(J, W);

  const double lambda = impulse(J, V, b, K);
  p.answer("lambda", "kg/s", lambda);
  Velocities after = V;
  after += lambda * over_masses(J, W);
  p.law("after the impulse, JV = −b", "m²/s", dot(J, after), -b);
}

void film(Film& film, const Code& code) {
  RodPieces pieces;
  pieces.impulse = std::get<0>(Learners::of(code));
  two_boxes(film, pieces);
}
