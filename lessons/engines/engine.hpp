#pragma once

#include <functional>
#include <memory>
#include <string>
#include <vector>

#include "lessons/engines/settings.hpp"
#include "solver/constraints/distance.hpp"
#include "solver/constraints/pin.hpp"
#include "solver/scene.hpp"

// The same scene in other people's engines. An adapter is one file: it builds an engine's world from one of our
// scenes (boxes, a half-space as ground, pins, rods), steps it, and reads poses and velocities back into the
// scene's bodies, so that all are measured by the same functions. Sleeping is off. What an adapter sets besides,
// because the engine counts otherwise than we do, stands in its file; what is turned, in settings/.
namespace byhand::engines {

/// What all threads of this program have computed, whatever else the machine does [s].
double processor_seconds();

/// A scene that runs in an engine.
template <class M>
class World {
 public:
  virtual ~World() = default;
  virtual void step(double h) = 0;  // [s]
  virtual void read(Bodies<M>& bodies) const = 0;
  /// Gives each body that moves the velocity that it has there.
  virtual void set_velocities(const Bodies<M>& bodies) = 0;
  /// The clock of its steps: processor time of the program that takes them [s].
  virtual double seconds() const { return processor_seconds(); }
};

/// Builds the world of a scene.
template <class M>
using Build = std::function<std::unique_ptr<World<M>>(const Scene<M>&, const Knobs&)>;

/// How many of each a scene has, by which an engine may refuse it.
struct Asked {
  int pins = 0, rods = 0, boxes = 0;
  int longest_path = 0;  // of bodies, each joined to the next
};

/// Where an engine is at home.
enum class Home { plane, space, both };

/// An engine in one of its modes. One of space runs a scene in the plane too, by what it has for holding bodies
/// there; a contest of costs in the plane leaves it out.
struct Engine {
  std::string name;          // "Box2D 3"
  std::string version = {};  // "3.2.0"; none of this course
  std::string earlier = {};  // the name of an earlier version that takes part, too
  std::string method = {};   // how it solves, in a few words
  std::string file = {};     // of its settings, from the root of the repository
  Home home = Home::space;
  bool single = false;       // precision
  bool random_rows = false;  // taken in random order, from the knob "seed"
  std::string build = {};    // a remark on how it was compiled, if that matters
  Settings settings = {};
  /// Why it does not run such a scene, in one clause; empty if it does.
  std::string (*refusal)(const Asked&) = nullptr;
  Build<PlaneBody> in_plane = {};
  Build<SpaceBody> in_space = {};
};

/// Why an engine does not run a scene; empty if it does.
template <class M>
std::string refusal(const Engine& engine, const Scene<M>& scene);

/// This course's solver by velocities, as one more engine.
const Engine& this_course();
/// The engines that this program was built with.
const std::vector<Engine>& all_engines();
/// The names of those that it was built without.
const std::vector<std::string>& missing();

/// Engines that exist in WebAssembly alone, under node: their times are set beside this course in WebAssembly,
/// which is the first of them, and beside no other. None without it.
const std::vector<Engine>& engines_in_webassembly();
/// The names of those that are not installed.
const std::vector<std::string>& missing_in_webassembly();

// What the adapters share.

/// Calls pin(Pin) or rod(Distance) for each constraint of the scene. Throws std::invalid_argument for any other.
template <class M, class OnPin, class OnRod>
void for_each_joint(const Scene<M>& scene, OnPin&& pin, OnRod&& rod) {
  for (int place = 0; place < scene.count(); ++place)
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
