#pragma once

#include <algorithm>
#include <cmath>
#include <variant>
#include <vector>

#include "solver/byhand.hpp"

namespace byhand::doctor {

/// The length of each body's shape [m]: a ball's diameter, and what `of_sides` takes of a box's; 0 without one,
/// and of a half-space.
template <class M, class OfSides>
std::vector<double> lengths_of_shapes(const Scene<M>& scene, OfSides&& of_sides) {
  std::vector<double> all(static_cast<std::size_t>(scene.bodies().size()), 0.0);
  for (std::size_t i = 0; i < scene.colliders().shapes.size(); ++i) {
    const Shape<M>& shape = scene.colliders().shapes[i];
    if (const auto* round = std::get_if<Ball<M>>(&shape)) all[i] = 2 * round->radius;
    if constexpr (M::angular > 0)
      if (const auto* block = std::get_if<Box<M>>(&shape)) all[i] = of_sides(block->sides);
  }
  return all;
}

/// The length of each body [m]: of its shape, else twice its longest arm, else a rod's length.
template <class M>
std::vector<double> sizes(const Scene<M>& scene) {
  std::vector<double> all = lengths_of_shapes(scene, [](const Linear<M>& sides) { return sides.maxCoeff(); });
  const std::vector<double> shapes = all;
  const auto take = [&](int body, double length) {
    const auto at = static_cast<std::size_t>(body);
    if (shapes[at] == 0) all[at] = std::max(all[at], length);
  };
  const auto holds = [&](const auto& constraint) {
    if constexpr (M::angular > 0) {
      take(constraint.at.body1, 2 * constraint.at.arms.first.norm());
      take(constraint.at.body2, 2 * constraint.at.arms.second.norm());
    }
    if constexpr (requires { constraint.length; }) {
      if (all[static_cast<std::size_t>(constraint.at.body1)] == 0) take(constraint.at.body1, constraint.length);
      if (all[static_cast<std::size_t>(constraint.at.body2)] == 0) take(constraint.at.body2, constraint.length);
    }
  };
  for (const auto& one : scene.template all<Pin<M>>()) holds(one);
  for (const auto& one : scene.template all<Distance<M>>()) holds(one);
  for (const auto& one : scene.template all<NormalisedDistance<M>>()) holds(one);
  for (const auto& one : scene.template all<Rope<M>>()) holds(one);
  if constexpr (M::angular > 0) {
    for (const auto& one : scene.template all<Weld<M>>()) holds(one);
    for (const auto& one : scene.template all<Slider<M>>()) holds(one);
  }
  if constexpr (M::angular == 3)
    for (const auto& one : scene.template all<Hinge<M>>()) holds(one);
  return all;
}

/// The smallest of all bodies that have a size [m]; infinity where none has.
inline double smallest_of(const std::vector<double>& sizes) {
  double smallest = INFINITY;
  for (const double size : sizes)
    if (size > 0) smallest = std::min(smallest, size);
  return smallest;
}

/// The smaller of two bodies' sizes [m]; the other's where one has none, 1 where none has.
inline double size_of_both(const std::vector<double>& sizes, int body1, int body2) {
  const double one = sizes[static_cast<std::size_t>(body1)], two = sizes[static_cast<std::size_t>(body2)];
  const double both = one > 0 && two > 0 ? std::min(one, two) : std::max(one, two);
  return both > 0 ? both : 1;
}

}  // namespace byhand::doctor
