#pragma once

#include <vector>

#include "solver/scene.hpp"

namespace byhand {

template <class M>
struct ContactPair;

/// Drops the contacts of moving bodies with inner edges of what bears them. A body above a face of another cannot
/// reach a third that rises nowhere above this face: tiles that lie flush are one floor, and where a tile ends
/// under a body that rolls or slides there is no corner.
template <class M>
class InnerEdges {
 public:
  void drop(const Scene<M>& scene, std::vector<ContactPair<M>>& pairs);

 private:
  /// A moving body's contact with another, by the place of its pair, and the outward normal of the latter.
  struct Support {
    int body, ground, pair;
    Linear<M> normal;
  };
  std::vector<Support> supports_;  // scratch
};

}  // namespace byhand
