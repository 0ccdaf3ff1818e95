#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/11_pulley/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

// Several C are right, so no answer is compared: the laws judge.
void probe(Probe& p, const Code& code) {
  const auto functions = Learners::of(code);
  const auto& value = std::get<0>(functions);
  const auto& jacobian = std::get<1>(functions);
  Pulley pulley;
  pulley.wheel1 = p.vector("wheel1", "m", 2);
  pulley.wheel2 = p.vector("wheel2", "m", 2);
  pulley.ratio = p.number("ratio", "1", 1.5, 4);
  const Vec2 r1 = p.vector("r1", "m", 0.5), r2 = p.vector("r2", "m", 0.5);
  const Vec2 down1 = p.vector("d1", "m", 3), down2 = p.vector("d2", "m", 3);
  const Vec2 p1 = pulley.wheel1 + down1 - r1, p2 = pulley.wheel2 + down2 - r2;
  pulley.L = length(down1) + pulley.ratio * length(down2);
  const Velocities V = p.velocities("V");

  p.law("where the rope is just taut, C = 0", "m", value(p1, r1, p2, r2, pulley), 0);
  const BodyRow J = jacobian(p1, r1, p2, r2, pulley);
  const auto later = [&](double t) {
    return value(p1 + t * V.v1, turned(r1, t * V.w1), p2 + t * V.v2, turned(r2, t * V.w2), pulley);
  };
  // Of sixth order, so that only rounding is left.
  constexpr double t = 1e-3;
  const double rate =
      (45 * (later(t) - later(-t)) - 9 * (later(2 * t) - later(-2 * t)) + (later(3 * t) - later(-3 * t))) /
      (60 * t);
  p.law("J is the gradient of C, so JV = dC/dt", "m/s", dot(J, V), rate);
  // Body 1 sinks by `ratio` while body 2 rises by 1: no rope is needed.
  const Velocities runs{pulley.ratio * unit(down1), 0, -unit(down2), 0};
  p.law("if the rope runs over its wheels, JV = 0: l1·v1 = −l2·v2", "m/s", dot(J.l1, runs.v1),
        -dot(J.l2, runs.v2));
  p.law("if all is shifted, C stays", "m",
        value(p1 + V.v1, r1, p2 + V.v1, r2,
              {pulley.wheel1 + V.v1, pulley.wheel2 + V.v1, pulley.ratio, 1.3 * pulley.L}),
        value(p1, r1, p2, r2, {pulley.wheel1, pulley.wheel2, pulley.ratio, 1.3 * pulley.L}));
  const double slack = value(p1, r1, p2, r2, {pulley.wheel1, pulley.wheel2, pulley.ratio, 1.3 * pulley.L});
  p.law("if the rope is longer than the way, C < 0", "m", slack, -std::max(std::abs(slack), 0.01));
}

void film(Film& film, const Code& code) {
  const auto [value, jacobian] = Learners::of(code);
  film.title = "Two boxes on a pulley of ratio 2";
  film.quantity = "length of the rope";
  film.unit = "m";
  const Pulley pulley{{-0.9, 1.6}, {0.9, 1.6}, 2, 5.5};
  Body one{.at = {-0.9, -0.3}, .mass = 1.2, .inertia = 0.05, .sides = {0.5, 0.5}};
  Body two{.at = {0.9, -0.45}, .mass = 2, .inertia = 0.1, .sides = {0.7, 0.5}};
  const InverseMasses masses{1 / one.mass, 1 / one.inertia, 1 / two.mass, 1 / two.inertia};
  constexpr double h = time_step;
  for (int i = 0; i <= 120; ++i) {
    const Vec2 r1 = turned({0.15, 0.25}, one.angle), r2 = turned({-0.1, 0.25}, two.angle);
    const Vec2 d1 = one.at + r1 - pulley.wheel1, d2 = two.at + r2 - pulley.wheel2;
    if (i % 2 == 0)
      film.frames.push_back({{{Shape::rod, pulley.wheel1, one.at + r1},
                              {Shape::rod, pulley.wheel1, pulley.wheel2},
                              {Shape::rod, pulley.wheel2, two.at + r2},
                              {Shape::anchor, pulley.wheel1, {}},
                              {Shape::anchor, pulley.wheel2, {}},
                              {Shape::box, one.at, one.sides, one.angle},
                              {Shape::box, two.at, two.sides, two.angle}},
                             length(d1) + pulley.ratio * length(d2)});
    one.v.y -= 9.81 * h;
    two.v.y -= 9.81 * h;
    const BodyRow J = jacobian(one.at, r1, two.at, r2, pulley);
    Velocities V{one.v, one.w, two.v, two.w};
    V = solved(J, V, masses, rate_that_keeps(value(one.at, r1, two.at, r2, pulley), 0.8, h)).V;
    one.v = V.v1, one.w = V.w1, two.v = V.v2, two.w = V.w2;
    for (Body* body : {&one, &two}) {
      body->at += h * body->v;
      body->angle += h * body->w;
    }
  }
}
