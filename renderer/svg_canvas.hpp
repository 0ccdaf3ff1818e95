#pragma once

#include <functional>
#include <string>
#include <string_view>
#include <vector>

#include "renderer/canvas.hpp"
#include "renderer/drawing_surface.hpp"
#include "renderer/space.hpp"

namespace byhand::renderer {

/// A canvas that writes SVG: text stays text in "DejaVu Sans", and one point is one unit.
class SvgCanvas : public Canvas {
 public:
  /// A scene in space in a part of the page, which SVG cannot draw itself.
  struct Window {
    Space scene;
    PixelBox frame;
  };
  /// Draws it and returns the address of the picture: of a file, or one that holds it (data_url.hpp).
  using DrawWindow = std::function<std::string(const Window&, const PageSize& page, Colour paper)>;

  /// A page of `width` × 720 points. `name` begins each id in the picture, so that several can be in one document.
  /// Without `draw_window`, the paper has holes where the windows are, for a canvas that lies below the picture.
  SvgCanvas(int width, std::string name, DrawWindow draw_window = {});

  /// The page. Screen readers read the title and the description. The same drawing gives the same bytes.
  std::string svg(std::string_view title, std::string_view description = {}) const;

  const std::vector<Window>& windows() const;

 private:
  class Surface;
};

}  // namespace byhand::renderer
