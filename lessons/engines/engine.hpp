#pragma once

#include <memory>
#include <string>
#include <vector>

#include "solver/constraints/distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

// The same scene in other people's engines. An adapter is one file: it builds an engine's world from one of our
// scenes (boxes, a half-space as ground, pins, rods), steps it, and reads poses and velocities back into the
// scene's bodies, so that all are measured by the same functions. Sleeping is off. What an adapter sets besides,
// because the engine counts otherwise than we do, stands in its file.
namespace byhand::engines {

/// A scene that runs in an engine.
template <class M>
class World {
 public:
  virtual ~World() = default;
  virtual void step(double h) = 0;  // [s]
  virtual void read(Bodies<M>& bodies) const = 0;
};

/// An engine in one of its modes.
struct Engine {
  std::string name;       // "Box2D 3"
  std::string version;    // "3.2.0"
  std::string knob = {};  // "substeps" or "iterations"; empty: it has none
  int usual = 1;          // the knob's default
  bool rods = true;       // whether it has a rigid rod between two bodies that turn
  bool plane = false;     // whether it knows the plane alone
  std::unique_ptr<World<PlaneBody>> (*in_plane)(const Scene<PlaneBody>&, int knob) = nullptr;
  std::unique_ptr<World<SpaceBody>> (*in_space)(const Scene<SpaceBody>&, int knob) = nullptr;
};

/// The engines that this program was built with.
const std::vector<Engine>& all_engines();
/// The names of those that it was built without.
const std::vector<std::string>& missing();

// What the adapters share.

/// Calls pin(Pin) or rod(Distance) for each constraint of the scene. Throws std::invalid_argument for any other.
template <class M, class OnPin, class OnRod>
void for_each_joint(const Scene<M>& scene, OnPin&& pin, OnRod&& rod) {
  for (int place = 0; place < scene.lasting(); ++place)
    if (const auto* joint = scene.template get_if<Pin<M>>(place))
      pin(*joint);
    else if (const auto* distance = scene.template get_if<Distance<M>>(place))
      rod(*distance);
    else
      throw std::invalid_argument("the engines are given pins and rods only");
}

/// Calls box(body, Box, Surface) or ground(body, HalfSpace, Surface) for each shape. Throws std::invalid_argument
/// for any other.
template <class M, class OnBox, class OnGround>
void for_each_shape(const Scene<M>& scene, OnBox&& box, OnGround&& ground) {
  const Colliders<M>& colliders = scene.colliders();
  for (int body = 0; body < static_cast<int>(colliders.shapes.size()); ++body) {
    const Surface& surface = colliders.surfaces[body];
    if (const auto* sides = std::get_if<Box<M>>(&colliders.shapes[body]))
      box(body, *sides, surface);
    else if (const auto* half_space = std::get_if<HalfSpace<M>>(&colliders.shapes[body]))
      ground(body, *half_space, surface);
    else if (!std::holds_alternative<std::monostate>(colliders.shapes[body]))
      throw std::invalid_argument("the engines are given boxes and a ground only");
  }
}

/// Half the breadth and the depth of the box that stands for a half-space where an engine has none [m].
constexpr double ground_breadth = 200, ground_depth = 1;

}  // namespace byhand::engines
