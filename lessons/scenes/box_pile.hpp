#pragma once

#include <cstdint>
#include <random>

#include "lessons/scenes/boxes.hpp"

namespace byhand {

/// What a random pile is drawn from, the same everywhere for the same draw.
struct PileOptions {
  int count = 10;     // of balls and boxes
  double speed = 10;  // each component of v [m/s] and ω [rad/s] is at most this
  int decades = 3;    // masses are between 10 to the power of -decades and +decades [kg]
  Surface surface = {.friction = 0.6, .restitution = 0.5};
};

/// Balls and boxes of 0.2 to 2 m, turned and moving anyhow, dropped where they come, also into each other, onto
/// the ground. Body 0 is the ground.
template <class M>
Scene<M> box_pile(std::uint64_t draw, const PileOptions& pile = {}) {
  std::mt19937_64 bits(draw);
  const auto uniform = [&](double low, double high) {
    return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
  };
  const auto any = [&]<int n>(std::integral_constant<int, n>, double low, double high) {
    Eigen::Matrix<double, n, 1> v;
    for (double& x : v) x = uniform(low, high);
    return v;
  };
  constexpr std::integral_constant<int, M::linear> axes;
  Scene<M> scene;
  add_ground(scene, pile.surface);
  for (int i = 0; i < pile.count; ++i) {
    double mass = uniform(0.1, 1);
    for (double decade = uniform(-pile.decades, pile.decades); std::abs(decade) > 0.5;
         decade -= decade > 0 ? 1 : -1)
      mass *= decade > 0 ? 10 : 0.1;
    Pose<M> pose;
    pose.position = any(axes, -2, 2) + 3 * Linear<M>::Unit(1);
    if constexpr (M::angular == 1)
      pose.rotation = plane_rotation(uniform(-3, 3));
    else
      pose.rotation = space_rotation(any(axes, -2, 2));
    const Velocity<M> velocity = any(std::integral_constant<int, M::dof>(), -pile.speed, pile.speed);
    const bool round = uniform(0, 1) < 0.4;
    const Linear<M> sides = any(axes, 0.2, 2);
    const int body = scene.add_body(pose, round ? ball<M>(mass, 0.5 * sides.x()) : box<M>(mass, sides), velocity);
    if (round)
      scene.set_shape(body, Ball<M>{0.5 * sides.x()}, pile.surface);
    else
      scene.set_shape(body, Box<M>{sides}, pile.surface);
  }
  return scene;
}

}  // namespace byhand
