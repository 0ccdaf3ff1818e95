#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/02_rod_between_bodies/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

/// A number and its rate.
struct Dual {
  double at, rate;
};
inline Dual operator+(Dual a, Dual b) { return {a.at + b.at, a.rate + b.rate}; }
inline Dual operator*(Dual a, Dual b) { return {a.at * b.at, a.rate * b.at + a.at * b.rate}; }

void probe(Probe& p, const Code& code) {
  const auto [jacobian] = Learners::of(code);
  const Vec2 r1 = p.vector("r1", "m", p.sized(2)), r2 = p.vector("r2", "m", p.sized(2)),
             d = p.vector("d", "m", p.sized(3));
  const Velocities V = p.velocities("V");

  const BodyRow J = jacobian(r1, r2, d);
  p.answer("J.l1", "m", J.l1);
  p.answer("J.a1", "m²", J.a1);
  p.answer("J.l2", "m", J.l2);
  p.answer("J.a2", "m²", J.a2);

  // The anchors' velocities, and ½d² with its rate.
  const Vec2 apart = V.v2 + cross(V.w2, r2) - V.v1 - cross(V.w1, r1);
  const Dual x{d.x, apart.x}, y{d.y, apart.y};
  const Dual C = Dual{0.5, 0} * (x * x + y * y);
  p.law("J is the gradient of C, so JV = dC/dt", "m²/s", dot(J, V), C.rate);
  // Both bodies are one rigid piece that turns by 1 rad/s about anchor 1.
  const Velocities rigid{cross(1.0, -r1), 1, cross(1.0, d - r2), 1};
  p.law("if both turn as one piece, JV = 0", "m²/s", dot(J.l1, rigid.v1) + J.a1, -dot(J.l2, rigid.v2) - J.a2);
  const BodyRow swapped = jacobian(r2, r1, -d);
  p.law("if the bodies swap their names, J swaps its halves", "m²", swapped.a1, J.a2);
}

void film(Film& film, const Code& code) {
  RodPieces pieces;
  pieces.jacobian = std::get<0>(Learners::of(code));
  two_boxes(film, pieces);
}
