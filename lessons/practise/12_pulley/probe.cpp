#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/12_pulley/signature.hpp"
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

  const double way = pulley.L;
  const auto with = [&](double L) { return Pulley{pulley.wheel1, pulley.wheel2, pulley.ratio, L}; };
  const auto C = [&](double L) { return value(p1, r1, p2, r2, with(L)); };
  const double tight = C(0.8 * way);
  p.sign("if the rope is shorter than the way, C > 0", "m", tight, 1);
  p.sign("if the rope is longer than the way, C < 0", "m", C(1.3 * way), -1);
  // C may have any scale, which is divided out of its laws.
  const double scale = tight > 0 && std::isfinite(tight) ? tight / (0.2 * way) : 1;
  p.law("where the rope is just taut, C = 0", "m", C(way) / scale, 0);
  const auto J = [&](double L) { return 1 / scale * jacobian(p1, r1, p2, r2, with(L)); };
  for (const auto& [L, where] : {std::pair{way, "taut"}, {1.3 * way, "slack"}, {0.8 * way, "too short"}})
    p.law(std::string("J is the gradient of C where the rope is ") + where + ", so JV = dC/dt", "m/s",
          dot(J(L), V), rate_of([&, &length = L](double t) {
            return value(p1 + t * V.v1, turned(r1, t * V.w1), p2 + t * V.v2, turned(r2, t * V.w2), with(length)) /
                   scale;
          }));
  const BodyRow taut = J(way);
  p.sign("where the rope is taut, C grows as body 1 moves away from its wheel: l1·v1 > 0", "m/s",
         dot(taut.l1, unit(down1)) - 1e-6, 1);
  p.sign("where the rope is taut, C grows as body 2 moves away from its wheel: l2·v2 > 0", "m/s",
         dot(taut.l2, unit(down2)) - 1e-6, 1);
  // Body 1 sinks by `ratio` while body 2 rises by 1: no rope is needed.
  const Velocities runs{pulley.ratio * unit(down1), 0, -unit(down2), 0};
  p.law("if the rope runs over its wheels, JV = 0: l1·v1 = −l2·v2", "m/s", dot(taut.l1, runs.v1),
        -dot(taut.l2, runs.v2));
  p.law(
      "if all is shifted, C stays", "m",
      value(p1 + V.v1, r1, p2 + V.v1, r2, {pulley.wheel1 + V.v1, pulley.wheel2 + V.v1, pulley.ratio, 1.3 * way}) /
          scale,
      C(1.3 * way) / scale);
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
