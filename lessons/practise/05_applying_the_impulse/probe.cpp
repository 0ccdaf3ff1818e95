#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/05_applying_the_impulse/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

void probe(Probe& p, const Code& code) {
  const auto [apply_impulse] = Learners::of(code);
  const BodyRow J = p.row("J");
  const Velocities V = p.velocities("V");
  const double lambda = p.number("lambda", "kg/s", -p.sized(3), p.sized(3));
  const InverseMasses W = p.inverse_masses();

  Velocities after = V;
  apply_impulse(after, J, lambda, W);
  p.answer("v1", "m/s", after.v1);
  p.answer("w1", "rad/s", after.w1);
  p.answer("v2", "m/s", after.v2);
  p.answer("w2", "rad/s", after.w2);

  // A row between two bodies gives to one what it takes from the other.
  const BodyRow between{-J.l2, J.a1, J.l2, J.a2};
  after = V;
  apply_impulse(after, between, lambda, W);
  const auto momentum = [&](const Velocities& of) { return 1 / W.m1 * of.v1 + 1 / W.m2 * of.v2; };
  p.law("the sum of the momenta along x stays", "kg m/s", momentum(after).x, momentum(V).x);
  p.law("the sum of the momenta along y stays", "kg m/s", momentum(after).y, momentum(V).y);
  Velocities after_17 = V;
  apply_impulse(after_17, J, solved(J, V, W, 0).lambda, W);
  p.law("after the impulse of (17), JV = 0: J·(after − before) = −J·before", "m²/s", dot(J, after_17) - dot(J, V),
        -dot(J, V));
}

void film(Film& film, const Code& code) {
  const auto apply = std::get<0>(Learners::of(code));
  RodPieces pieces;
  pieces.apply = [apply](Velocities& V, const BodyRow& J, double lambda, const InverseMasses& W) {
    apply(V, J, lambda, W);
  };
  two_boxes(film, pieces);
}
