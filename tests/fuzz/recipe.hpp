#pragma once

#include <string>
#include <vector>

#include "solver/scene.hpp"

namespace byhand::fuzz {

/// A scene as plain data: it can be looked at from elsewhere, made smaller and printed.
template <class M>
struct Recipe {
  struct Part {
    Pose<M> pose = {};
    Velocity<M> velocity = Velocity<M>::Zero();
    Shape<M> shape = {};
    double mass = 0;  // [kg]; 0 holds it
    double friction = 0;
  };
  enum class Joint { pin, weld, rod };
  struct Link {
    Joint joint;
    int first, second;
    Linear<M> at;  // in the world [m]; a rod joins the centres
  };

  Linear<M> gravity = -9.81 * Linear<M>::Unit(1);
  ContactRows rows = M::linear == 2 ? ContactRows::manifold : ContactRows::points;
  double margin = 0.02;  // [m]
  double lookahead = 1;
  std::vector<Part> parts;
  std::vector<Link> links;
};

/// The uniform mass of a part.
template <class M>
InverseMass<M> mass_of(const typename Recipe<M>::Part& part);

template <class M>
Scene<M> scene_of(const Recipe<M>& recipe);

/// C++ that makes the scene, to paste into a test.
template <class M>
std::string code_of(const Recipe<M>& recipe);

}  // namespace byhand::fuzz
