#pragma once

#include "solver/constraints/normalised_distance.hpp"
#include "solver/scene.hpp"

namespace byhand {

/// A chain of 1 kg and `length` [m], cut into an even number of rods with a bob at every joint, between two
/// anchors `span` [m] < length apart at the height of the origin. At rest as a V, which is not where it comes to
/// rest. Bodies are numbered from left to right, anchors included.
template <class M>
Scene<M> slack_chain(int links, double length, double span) {
  require(links >= 2 && links % 2 == 0, "number of links", links, "an even number of at least 2");
  require_inside("span", span, 0, length, "m");
  Scene<M> scene;
  const double depth = std::sqrt(length * length - span * span) / 2;
  for (int i = 0; i <= links; ++i) {
    const double across = 2.0 * i / links - 1;  // -1 on the left, 1 on the right
    const bool end = i == 0 || i == links;
    scene.add_body(
        Linear<M>(span / 2 * across * Linear<M>::Unit(0) - depth * (1 - std::abs(across)) * Linear<M>::Unit(1)),
        end ? fixed<M>() : with_mass<M>(1.0 / links));
    if (i > 0) scene.add(NormalisedDistance<M>{{i - 1, i}, length / links});
  }
  return scene;
}

}  // namespace byhand
