#pragma once

#include <string>

#include "renderer/canvas.hpp"
#include "renderer/image.hpp"

namespace byhand::renderer {

/// A canvas whose page OpenGL draws without a window.
class PixelCanvas : public Canvas {
 public:
  /// A page of `width` × `height` pixels (16 … 8192 each, else std::invalid_argument). Throws Unavailable
  /// without OpenGL or the font.
  PixelCanvas(int width, int height);

  /// Renders the page.
  Image image();
  /// OpenGL's renderer, its version and the library that made the context, for manifest.json.
  const std::string& describe() const;

 private:
  class Surface;
  explicit PixelCanvas(const PageSize& size);
};

}  // namespace byhand::renderer
