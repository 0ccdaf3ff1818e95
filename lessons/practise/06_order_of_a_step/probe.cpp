#include "lessons/practise/judge/probe.hpp"
#include "lessons/practise/06_order_of_a_step/signature.hpp"
#include "lessons/practise/judge/stage.hpp"

void probe(Probe& p, const Code& code) {
  const auto [step] = Learners::of(code);
  const Vec2 at = p.vector("p", "m", 3);
  const double across = p.number("speed", "m/s", -3, 3), m = p.number("m", "kg", 0.3, 5),
               g = p.number("g", "m/s²", 2, 20), h = p.number("h", "s", 0.004, 0.03);
  const double L = length(at);

  Pendulum bob{at, across / L * Vec2{-at.y, at.x}, m, g};
  step(bob, h);
  p.answer("p, 1 step", "m", bob.p);
  p.answer("v, 1 step", "m/s", bob.v);
  p.answer("C, 1 step", "m²", (dot(bob.p, bob.p) - L * L) / 2);
  for (double t = h; t < 1; t += h) step(bob, h);
  p.answer("p, 1 s", "m", bob.p);

  Pendulum hanging{{0, -L}, {}, m, g};
  for (int i = 0; i < 10; ++i) step(hanging, h);
  p.law("a hanging bob rests", "m", hanging.p.y, -L);
  Pendulum heavy{at, {}, 7 * m, g}, light{at, {}, m, g};
  step(heavy, h);
  step(light, h);
  p.law("the motion does not depend on m", "m", heavy.p.x, light.p.x);
}

void film(Film& film, const Code& code) {
  const auto [step] = Learners::of(code);
  film.title = "Bob on a rod of 2 m, let go at 90°";
  film.quantity = "distance from the anchor";
  film.unit = "m";
  Pendulum bob{{2, 0}, {}, 2, 9.81};
  for (int i = 0; i <= 240; ++i) {
    if (i % 2 == 0)
      film.frames.push_back(
          {{{Shape::rod, {}, bob.p}, {Shape::anchor, {}, {}}, {Shape::bob, bob.p, {0.16, 0}}}, length(bob.p)});
    step(bob, time_step);
  }
}
