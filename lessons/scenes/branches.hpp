#pragma once

#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

// Graphs that are not chains, to see what the structured direct solve makes of them.
namespace byhand {

/// A binary tree of pinned links of 1 m and 1 kg, `levels` deep, hanging from the origin with each pair of
/// children spread sideways. Body 0 is the anchor.
template <class M>
Scene<M> pinned_tree(int levels) {
  require(levels >= 1 && levels <= 20, "number of levels", levels, "between 1 and 20");
  Scene<M> scene;
  struct Tip {
    int body;
    Linear<M> point;
  };
  const Linear<M> sides = Linear<M>::Constant(0.2);
  std::vector<Tip> tips{{scene.add_body(Linear<M>(Linear<M>::Zero()), fixed<M>()), Linear<M>::Zero()}};
  for (int level = 0; level < levels; ++level) {
    std::vector<Tip> next;
    for (const Tip& tip : tips)
      for (const double side : {-1.0, 1.0}) {
        if (level == 0 && side > 0) continue;
        const Linear<M> end =
            tip.point - Linear<M>::Unit(1) + (level == 0 ? 0.0 : 0.5 * side) * Linear<M>::Unit(0);
        const int link = scene.add_body(Linear<M>(0.5 * (tip.point + end)), box<M>(1, sides));
        scene.add(pin<M>(scene.bodies(), tip.body, link, tip.point));
        next.push_back({link, end});
      }
    tips = next;
  }
  return scene;
}

/// `arms` links of 1 m and 1 kg pinned to the rim of one free hub of 1 m radius and 10 kg. Body 0 is the hub.
template <class M>
Scene<M> pinned_star(int arms) {
  require(arms >= 1, "number of arms", arms, "at least 1");
  Scene<M> scene;
  const int hub = scene.add_body(Linear<M>(Linear<M>::Zero()), ball<M>(10, 1));
  for (int i = 0; i < arms; ++i) {
    const auto [sin, cos] = sin_cos(2 * 3.14159265358979323846 * i / arms);
    const Linear<M> out = cos * Linear<M>::Unit(0) + sin * Linear<M>::Unit(1);
    const int arm = scene.add_body(Linear<M>(1.5 * out), box<M>(1, Linear<M>::Constant(0.2)));
    scene.add(pin<M>(scene.bodies(), hub, arm, out));
  }
  return scene;
}

}  // namespace byhand
