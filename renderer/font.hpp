#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string_view>
#include <tuple>
#include <vector>

#include "renderer/outline.hpp"

namespace byhand::renderer {

/// Letters of DejaVu Sans as grey pixels in one atlas, made when first needed.
class Font {
 public:
  /// Throws EnvironmentError when the font is not installed.
  Font();
  ~Font();

  /// The width in pixels of a line (markup as in Canvas) in letters of `size` pixels.
  double width(std::string_view line, double size, bool bold) const;

  /// Quads of a line whose baseline begins at `at` (pixels, y down); with `halo` > 0 pixels, of the letters
  /// swollen by so much instead. `upright` false turns it a quarter to the left about `at`.
  void write(Vertices& to, std::string_view line, const Point& at, double size, bool bold, Colour colour,
             double halo, bool upright);

  static constexpr int atlas_width = 1024;
  int atlas_height() const { return int(atlas_.size()) / atlas_width; }
  /// One byte a pixel, row by row. It only ever grows.
  const std::vector<std::uint8_t>& atlas() const { return atlas_; }

 private:
  struct Face;
  struct Placed {
    int glyph;
    double x, y, size;  // pixels right of the beginning of the line and up from its baseline
  };
  struct Slot {
    int u, v, width, height, left, top;  // left and top: from the pen to the corner, y down
  };
  struct Line {
    std::vector<Placed> letters;
    double width = 0;
  };
  static Line lay_out(std::string_view text, double size, const Face& face);
  const Slot& slot(const Face& face, bool bold, int glyph, double size, int phase, int halo);

  std::unique_ptr<Face> regular_, bold_;
  std::vector<std::uint8_t> atlas_;
  int row_top_ = 0, row_bottom_ = 0, row_end_ = 0;
  std::map<std::tuple<bool, int, int, int, int>, Slot> slots_;
};

}  // namespace byhand::renderer
