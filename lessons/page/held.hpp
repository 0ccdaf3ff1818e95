#pragma once

#include <functional>
#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "renderer/point.hpp"
#include "renderer/rectangle.hpp"

namespace byhand::renderer {
class Canvas;
}

namespace byhand::course {

/// A scene that a reader of a live page holds: takes a body by the hand, pulls it, lets it go, steps through time
/// and through the parts of one step. Points are on the page of its picture.
class Held {
 public:
  static constexpr int width = 960;                             // of its picture [points]
  static constexpr renderer::Rectangle page{0, 0, width, 720};  // as Canvas has it
  static constexpr int parts = 6;                               // of a step

  /// A body that can be held, and how far from its middle it reaches [points].
  struct Body {
    std::string name;
    renderer::Point at;
    double reach;
  };

  virtual ~Held() = default;

  virtual double h() const = 0;     // [s]
  virtual double time() const = 0;  // [s]
  virtual std::vector<Body> bodies() const = 0;
  /// Index among `bodies` of the one that is held, or -1.
  virtual int held() const = 0;
  /// Takes the body at this point, if there is one, and lets go of any other.
  virtual void grab(const renderer::Point& at) = 0;
  /// Moves the hand, which pulls its body along.
  virtual void move(const renderer::Point& to) = 0;
  virtual void release() = 0;

  /// One step of h, unless the scene has stopped.
  virtual void step() = 0;
  virtual void reset() = 0;
  /// Why it goes no further, in one sentence or two; empty while it goes on.
  virtual std::string stopped() const = 0;

  /// Goes on where `other` is, the same scene at other parameters, if both begin at the same poses.
  virtual void go_on_from(const Held& other) = 0;

  /// The scene now or, with `part` in [0, parts), within its next step: velocities, gravity, JV, λ, velocities,
  /// poses.
  virtual void draw(renderer::Canvas& canvas, std::optional<double> part = {}) const = 0;
  /// Time, energy, |C| and λ; within a step what its part does.
  virtual std::string words(std::optional<double> part = {}) const = 0;
};

/// What a step offers to hold. `scene` begins one at the present parameters.
struct Hold {
  std::string name, caption;
  std::function<std::unique_ptr<Held>()> scene;
};

}  // namespace byhand::course
