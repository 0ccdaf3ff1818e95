#pragma once

#include <optional>
#include <string>

#include "lessons/files/options.hpp"
#include "lessons/page/items.hpp"
#include "renderer/opengl/pixel_canvas.hpp"

namespace byhand::course {

/// Draws figures and frames at one quality. Opens OpenGL at the first picture. Every function may throw
/// EnvironmentError.
class PictureDrawer {
 public:
  explicit PictureDrawer(const Quality& quality) : quality_(quality) {}

  renderer::Image draw(const Figure& figure);
  renderer::Image draw(const FrameDrawing& frame, double time);

  /// Number of frames of a sequence, and the time that frame `index` gets.
  int count(const Sequence& sequence) const;
  double time(const Sequence& sequence, int index) const;
  /// Frames per second of a film of the sequence: slow enough to see each, if they are counted.
  double rate(const Sequence& sequence) const;

  /// OpenGL's renderer and version; empty before the first picture.
  std::string gl() const { return canvas_ ? canvas_->describe() : ""; }

 private:
  renderer::PixelCanvas& blank();

  Quality quality_;
  std::optional<renderer::PixelCanvas> canvas_;
};

/// For a terminal.
inline const Quality small_quality = {"small", 640, 360, 15};

}  // namespace byhand::course
