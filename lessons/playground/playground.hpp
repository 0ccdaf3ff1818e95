#pragma once

#include <memory>
#include <optional>
#include <string>
#include <vector>

#include "lessons/scene_file/scene_file.hpp"
#include "lessons/stage/looks.hpp"
#include "renderer/canvas.hpp"

namespace byhand::playground {

/// The directions of the world, each of length 1, that lie to the right and up in the picture. In the plane x and
/// y.
using Seen = Eigen::Matrix<double, 2, 3>;

/// A scene from a file, which runs, can be pulled at and written as a file again at any moment. What
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
  /// body x, y [m], cosine and sine of its angle; in space x, y, z [m] and the rows of its rotation.
  virtual void write_moment(std::vector<double>& numbers) const = 0;
  /// The file of this moment, which begins here.  What the hand holds is let go.
  virtual SceneFile file() const = 0;

  /// A hand takes a body at a point of the world [m], pulls it along to the right and up in the picture, lets it
  /// go.
  virtual void grab(int body, const Eigen::Vector3d& at, const Seen& seen) = 0;
  virtual void move(const Eigen::Vector3d& to) = 0;
  virtual void release() = 0;

  /// A part of the next step, as a lesson's held scenes show it (see pictures::StepTerms).
  struct Part {
    std::string formula, words;  // empty where the next step has no answer
    struct Moved {
      int body;
      std::vector<double> numbers;  // where it has come, as in a moment
    };
    std::vector<Moved> moved;
  };
  /// Draws its arrows into the picture that the canvas's camera shows, the longest about `longest` [m].
  virtual Part draw_part(renderer::Canvas& canvas, double part, double longest, const Seen& seen) const = 0;
};

/// Throws std::invalid_argument where the file's method cannot run its scene.
std::unique_ptr<Playground> begin(SceneFile file);

}  // namespace byhand::playground
