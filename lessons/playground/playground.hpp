#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lessons/scene_file/scene_file.hpp"
#include "lessons/stage/looks.hpp"
#include "renderer/canvas.hpp"

namespace byhand::playground {

/// A scene in the plane from a file, which runs, can be pulled at and written as a file again at any moment. What
/// a reader builds is built in the file; here it only moves.
class Playground {
 public:
  virtual ~Playground() = default;

  /// What is drawn of it.
  virtual stage::SceneLook look() const = 0;

  /// One step of h.  Throws std::runtime_error where it has no answer; then the scene stays as it was.
  virtual void step() = 0;
  /// Goes on from here by the method and with the step of another file.  Throws std::invalid_argument where that
  /// method cannot run this scene.
  virtual void use(const SceneFile& method) = 0;

  /// The numbers that a picture is drawn from: time [s], energy [J], the largest gap or overlap [m], and for each
  /// body x, y [m], cosine and sine of its angle.
  virtual void write_moment(std::vector<double>& numbers) const = 0;
  /// The file of this moment, which begins here.  What the hand holds is let go.
  virtual SceneFile file() const = 0;

  /// A hand takes a body at a point of the world [m], pulls it along, lets it go.
  virtual void grab(int body, const renderer::Point& at) = 0;
  virtual void move(const renderer::Point& to) = 0;
  virtual void release() = 0;

  /// A part of the next step, as a lesson's held scenes show it (see pictures::StepTerms).
  struct Part {
    std::string formula, words;  // empty where the next step has no answer
    struct Move {
      int body;
      renderer::Point by;  // [m]
      double turn;         // [rad]
    };
    std::vector<Move> moves;  // so far
  };
  /// Draws its arrows into the world of the canvas's camera, the longest about `longest` [m].
  virtual Part draw_part(renderer::Canvas& canvas, double part, double longest) const = 0;
};

/// Throws std::invalid_argument for a scene in space, and where the file's method cannot run its scene.
std::unique_ptr<Playground> begin(SceneFile file);

}  // namespace byhand::playground
