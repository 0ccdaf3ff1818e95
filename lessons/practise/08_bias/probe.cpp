#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/08_bias/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

void probe(Probe& p, const Code& code) {
  const auto [bias] = Learners::of(code);
  const double C = p.number("C", "m²", -p.sized(0.6), p.sized(0.6)), beta = p.number("beta", "1", 0.05, 0.9),
               h = p.number("h", "s", 0.003, 0.05);

  const double b = bias(C, beta, h);
  p.answer("b", "m²/s", b);
  // With JV = −b, a step changes C by −b h.
  p.law("after a step, C is (1 − β)C", "m²", C - b * h, (1 - beta) * C);
  p.law("if C doubles, b doubles", "m²/s", bias(2 * C, beta, h), 2 * b);
  p.law("half the step, twice the rate", "m²/s", bias(C, beta, h / 2), 2 * b);
}

void film(Film& film, const Code& code) {
  RodPieces pieces;
  pieces.bias = std::get<0>(Learners::of(code));
  two_boxes(film, pieces);
}
