#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/03_inverse_effective_mass/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

void probe(Probe& p, const Code& code) {
  const auto [inverse_effective_mass] = Learners::of(code);
  const BodyRow J = p.row("J", p.sized(2));
  const double m1 = p.number("m1", "kg", 0.3, 5), I1 = p.number("I1", "kg m²", 0.1, 3),
               m2 = p.number("m2", "kg", 0.3, 5), I2 = p.number("I2", "kg m²", 0.1, 3);

  const double K = inverse_effective_mass(J, m1, I1, m2, I2);
  p.answer("K", "m²/kg", K);
  p.law("if all masses double, K halves", "m²/kg", 2 * inverse_effective_mass(J, 2 * m1, 2 * I1, 2 * m2, 2 * I2),
        K);
  p.law("if J doubles, K is four times as large", "m²/kg", inverse_effective_mass(2.0 * J, m1, I1, m2, I2), 4 * K);
  p.law("if the bodies swap their names, K stays", "m²/kg",
        inverse_effective_mass({J.l2, J.a2, J.l1, J.a1}, m2, I2, m1, I1), K);
}

void film(Film& film, const Code& code) {
  const auto K = std::get<0>(Learners::of(code));
  RodPieces pieces;
  pieces.inverse_mass = [K](const BodyRow& J, const InverseMasses& W) {
    return K(J, 1 / W.m1, 1 / W.I1, 1 / W.m2, 1 / W.I2);
  };
  two_boxes(film, pieces);
}
