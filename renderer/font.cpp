#include "renderer/font.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

#include "renderer/code_points.hpp"
#include "renderer/error.hpp"
#include "renderer/font_file.hpp"
#include "renderer/mathematics.hpp"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace byhand::renderer {
namespace {

constexpr int phases = 4;       // subpixel positions of a glyph
constexpr int size_steps = 4;   // font sizes are multiples of a quarter of a pixel
constexpr double small = 0.72;  // relative size of subscripts and superscripts
constexpr double raise = 0.36, lower = 0.18;

bool combines(char32_t c) { return (c >= 0x300 && c <= 0x36f) || (c >= 0x20d0 && c <= 0x20ff); }

}  // namespace

struct Font::Face {
  explicit Face(const char* name) : data(font_file(name)) {
    if (!stbtt_InitFont(&info, data.data(), 0)) throw Unavailable(fmt::format("{} is not a font.", name));
  }

  double scale(double size) const { return stbtt_ScaleForMappingEmToPixels(&info, float(size)); }

  std::vector<unsigned char> data;
  stbtt_fontinfo info{};
};

Font::Font() {
  for (const char* name :
       {"DejaVuSans.ttf", "DejaVuSans-Oblique.ttf", "DejaVuSans-Bold.ttf", "DejaVuSans-BoldOblique.ttf"})
    faces_.emplace_back(name);
}
Font::~Font() = default;

std::vector<Font::Piece> Font::pieces(std::string_view text) {
  struct Sign {
    std::string_view bytes;
    int level, group;  // signs of one group are at one height
  };
  std::vector<Sign> signs;
  std::vector<LabelSign> label;
  int level = 0, group = 0;
  const auto take = [&] {  // the next code point
    const std::string_view before = text;
    label.push_back({next_code_point(text), level});
    signs.push_back({before.substr(0, before.size() - text.size()), level, group});
  };
  const auto take_escaped = [&] {
    if (text.front() == '\\' && text.size() > 1) text.remove_prefix(1);
    take();
  };
  while (!text.empty()) {
    const char c = text.front();
    if ((c != '_' && c != '^') || text.size() == 1) {
      take_escaped();
      continue;
    }
    text.remove_prefix(1);
    level = c == '^' ? 1 : -1, ++group;
    if (text.front() == '{') {
      text.remove_prefix(1);
      while (!text.empty() && text.front() != '}') take_escaped();
      if (!text.empty()) text.remove_prefix(1);
    } else {
      take_escaped();
      // A combining mark after a single raised letter belongs to it.
      for (std::string_view rest = text; !rest.empty() && combines(next_code_point(rest)); rest = text) take();
    }
    level = 0, ++group;
  }

  const std::vector<bool> italic = italics(label);
  std::vector<Piece> all;
  for (std::size_t i = 0; i < signs.size(); ++i) {
    const Sign& sign = signs[i];
    if (i == 0 || sign.group != signs[i - 1].group || italic[i] != italic[i - 1])
      all.push_back({"",
                     sign.level == 0  ? 0
                     : sign.level > 0 ? raise
                                      : -lower,
                     sign.level == 0 ? 1 : small, italic[i]});
    // A slanted letter leans on the bar behind it: |d| would look like |a|.
    constexpr std::string_view hair_space = "\u200a";
    if (i > 0 && italic[i - 1] && sign.bytes == "|") all.back().words += hair_space;
    all.back().words += sign.bytes;
  }
  return all;
}

Font::Line Font::lay_out(std::string_view text, double size, bool bold) const {
  Line line;
  double& pen = line.width;
  struct Box {
    double left, right, top;
  } base{};  // of the last base letter, in pixels
  for (const Piece& piece : pieces(text)) {
    const int index = 2 * bold + piece.italic;
    const Face& face = faces_[std::size_t(index)];
    const double letter_size = size * piece.factor, shift = size * piece.shift, scale = face.scale(letter_size);
    int previous = 0;
    for (std::string_view rest = piece.words; !rest.empty();) {
      const char32_t c = next_code_point(rest);
      const int glyph = stbtt_FindGlyphIndex(&face.info, int(c));
      int advance = 0, bearing = 0, x0 = 0, y0 = 0, x1 = 0, y1 = 0;
      stbtt_GetGlyphHMetrics(&face.info, glyph, &advance, &bearing);
      stbtt_GetGlyphBox(&face.info, glyph, &x0, &y0, &x1, &y1);
      if (combines(c)) {
        // Centres the mark over its letter and lifts it above tall letters: fonts place it for small ones.
        int small_top = 0, unused = 0;
        stbtt_GetCodepointBox(&face.info, 'x', &unused, &unused, &unused, &small_top);
        const double up = std::max(0.0, base.top - scale * small_top);
        line.letters.push_back(
            {index, glyph, (base.left + base.right - scale * (x0 + x1)) / 2, shift + up, letter_size});
      } else {
        if (previous) pen += scale * stbtt_GetGlyphKernAdvance(&face.info, previous, glyph);
        base = {pen + scale * x0, pen + scale * x1, scale * y1};
        line.letters.push_back({index, glyph, pen, shift, letter_size});
        pen += scale * advance;
        previous = glyph;
      }
    }
  }
  return line;
}

double Font::width(std::string_view line, double size, bool bold) const { return lay_out(line, size, bold).width; }

const Font::AtlasGlyph& Font::slot(const PlacedGlyph& of, int phase, int halo) {
  const Face& face = faces_[std::size_t(of.face)];
  const int glyph = of.glyph, steps = int(std::lround(of.size * size_steps));
  const auto [found, fresh] = slots_.try_emplace({of.face, glyph, steps, phase, halo});
  AtlasGlyph& slot = found->second;
  if (!fresh) return slot;

  const float scale = float(face.scale(double(steps) / size_steps)), shift = float(phase) / phases;
  int x0 = 0, y0 = 0, x1 = 0, y1 = 0;
  stbtt_GetGlyphBitmapBoxSubpixel(&face.info, glyph, scale, scale, shift, 0, &x0, &y0, &x1, &y1);
  const int w = x1 - x0, h = y1 - y0;
  if (w <= 0 || h <= 0) return slot;
  std::vector<std::uint8_t> letter(std::size_t(w) * h);
  stbtt_MakeGlyphBitmapSubpixel(&face.info, letter.data(), w, h, w, scale, scale, shift, 0, glyph);

  const int r = (halo + size_steps - 1) / size_steps, width = w + 2 * r, height = h + 2 * r;
  if (row_end_ + width > atlas_width) row_top_ = row_bottom_, row_end_ = 0;
  row_bottom_ = std::max(row_bottom_, row_top_ + height + 1);
  if (row_bottom_ > atlas_height()) atlas_.resize(std::size_t(atlas_width) * ((row_bottom_ + 255) / 256 * 256));
  slot = {row_end_, row_top_, width, height, x0 - r, y0 - r};
  row_end_ += width + 1;

  // Dilation: the maximum of the glyph within reach of each pixel.
  const double reach = double(halo) / size_steps;
  for (int dy = -r; dy <= r; ++dy) {
    for (int dx = -r; dx <= r; ++dx) {
      const double weight = std::clamp(reach + 0.5 - std::hypot(dx, dy), 0.0, 1.0);
      if (weight == 0 && halo > 0) continue;
      for (int y = 0; y < h; ++y)
        for (int x = 0; x < w; ++x) {
          const double grey = letter[std::size_t(y) * w + x] * (halo > 0 ? weight : 1);
          std::uint8_t& pixel = atlas_[std::size_t(slot.v + y + r + dy) * atlas_width + slot.u + x + r + dx];
          pixel = std::max(pixel, std::uint8_t(grey));
        }
    }
  }
  return slot;
}

void Font::write(Vertices& to, std::string_view line, const Point& at, double size, bool bold, Colour colour,
                 double halo, bool upright) {
  // Rotated by 90° anticlockwise, right becomes up and up becomes left.
  const double along = upright ? at.x() : -at.y(), down = upright ? at.y() : at.x();
  for (const PlacedGlyph& letter : lay_out(line, size, bold).letters) {
    const double x = along + letter.x;
    const double column = std::floor(x + 0.5 / phases);
    const int phase = std::clamp(int(std::floor((x - column) * phases + 0.5)), 0, phases - 1);
    const AtlasGlyph& s = slot(letter, phase, int(std::lround(halo * size_steps)));
    if (s.width == 0) continue;
    const double left = column + s.left, top = std::round(down - letter.y) + s.top;
    const auto corner = [&](int i, int j) {
      const double px = left + i * s.width, py = top + j * s.height;
      return Vertex{float(upright ? px : py), float(upright ? py : -px), float(s.u + i * s.width),
                    float(s.v + j * s.height), colour};
    };
    const Vertex a = corner(0, 0), b = corner(1, 0), c = corner(1, 1), d = corner(0, 1);
    to.insert(to.end(), {a, b, c, a, c, d});
  }
}

}  // namespace byhand::renderer
