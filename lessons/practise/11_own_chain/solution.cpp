#include <cstddef>
#include <vector>

#include "practise.hpp"

/// Of the rod that a bob hangs by, J = [−d, d].
struct Rod {
  Vec2 d;
  double K = 0, b = 0, lambda = 0;
};

Rod rod_of(std::size_t i, std::span<const Bob> bobs, const Setting& setting) {
  Rod rod;
  rod.d = i == 0 ? bobs[0].p : bobs[i].p - bobs[i - 1].p;                      // (11)
  const double C = (dot(rod.d, rod.d) - setting.length * setting.length) / 2;  // (2)
  rod.K = dot(rod.d, rod.d) * (i == 0 ? 1 : 2) / setting.mass;                 // (19)
  rod.b = setting.beta / setting.h * C;                                        // (21)
  return rod;
}

void solve(Rod& rod, std::size_t i, std::span<Bob> bobs, const Setting& setting) {
  const Vec2 above = i == 0 ? Vec2{} : bobs[i - 1].v;
  const double change = -(dot(rod.d, bobs[i].v - above) + rod.b) / rod.K;  // (17)
  const Vec2 push = change / setting.mass * rod.d;                         // (20)
  rod.lambda += change;
  bobs[i].v += push;
  if (i > 0) bobs[i - 1].v -= push;
}

void step(std::span<Bob> bobs, const Setting& setting) {
  for (Bob& bob : bobs) bob.v.y -= setting.g * setting.h;
  std::vector<Rod> rods;
  for (std::size_t i = 0; i < bobs.size(); ++i) rods.push_back(rod_of(i, bobs, setting));
  for (int sweep = 0; sweep < setting.sweeps; ++sweep)
    for (std::size_t i = 0; i < bobs.size(); ++i) solve(rods[i], i, bobs, setting);
  for (std::size_t i = 0; i < bobs.size(); ++i) {
    bobs[i].pull = -rods[i].lambda / setting.h * length(rods[i].d);  // (5)
    bobs[i].p += setting.h * bobs[i].v;
  }
}

void simulate(const Setting& setting, std::span<Bob> bobs) {
  for (int i = 0; i < setting.steps; ++i) step(bobs, setting);
}
