#pragma once

#include <cstdint>
#include <map>
#include <memory>
#include <string>
#include <string_view>
#include <tuple>
#include <vector>

#include "renderer/outline.hpp"

namespace byhand::renderer {

/// Glyphs of DejaVu Sans, rasterised on demand into one atlas of grey pixels.
class Font {
 public:
  /// Throws Unavailable if the font is not installed.
  Font();
  ~Font();

  /// Width [pixels] of a line, with markup as in Canvas, at font size `size` [pixels].
  double width(std::string_view line, double size, bool bold) const;

  /// Appends the quads of a line whose baseline begins at `at` (pixels, y down). A `halo` > 0 [pixels] dilates the
  /// glyphs. `upright` false rotates the line by 90° anticlockwise about `at`.
  void write(Vertices& to, std::string_view line, const Point& at, double size, bool bold, Colour colour,
             double halo, bool upright);

  /// A part of a line without markup: text of one style and size at one height.
  struct Piece {
    std::string words{};
    double shift = 0;   ///< of its baseline, upwards, in sizes of the line
    double factor = 1;  ///< its size, in sizes of the line
    bool italic = false;
  };
  static std::vector<Piece> pieces(std::string_view line);

  static constexpr int atlas_width = 1024;
  int atlas_height() const { return int(atlas_.size()) / atlas_width; }
  /// One byte per pixel, row by row. It never shrinks.
  const std::vector<std::uint8_t>& atlas() const { return atlas_; }

 private:
  struct Face;
  struct PlacedGlyph {
    int face, glyph;
    double x, y, size;  // pixels, from the beginning of the baseline, y up
  };
  struct AtlasGlyph {
    int u, v, width, height, left, top;  // left, top: offset of the corner from the pen, y down
  };
  struct Line {
    std::vector<PlacedGlyph> letters;
    double width = 0;
  };
  Line lay_out(std::string_view text, double size, bool bold) const;
  const AtlasGlyph& slot(const PlacedGlyph& letter, int phase, int halo);

  std::vector<Face> faces_;  // upright, italic, bold, bold italic
  std::vector<std::uint8_t> atlas_;
  int row_top_ = 0, row_bottom_ = 0, row_end_ = 0;
  std::map<std::tuple<int, int, int, int, int>, AtlasGlyph> slots_;
};

}  // namespace byhand::renderer
