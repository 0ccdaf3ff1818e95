#include "renderer/font.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <fstream>
#include <iterator>

#include "renderer/error.hpp"

#define STBTT_STATIC
#define STB_TRUETYPE_IMPLEMENTATION
#include <stb/stb_truetype.h>

namespace byhand::renderer {
namespace {

constexpr int phases = 4;       // subpixel positions of a glyph
constexpr int size_steps = 4;   // font sizes are multiples of a quarter of a pixel
constexpr double small = 0.72;  // relative size of subscripts and superscripts
constexpr double raise = 0.36, lower = 0.18;

// Decodes the next code point of UTF-8; an invalid byte is returned as it is.
char32_t next_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char head = byte(0);
  const std::size_t length = head >= 0xf0 ? 4 : head >= 0xe0 ? 3 : head >= 0xc0 ? 2 : 1;
  char32_t code = head;
  if (length > 1 && length <= text.size()) {
    code = head & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3f);
    text.remove_prefix(length);
  } else {
    text.remove_prefix(1);
  }
  return code;
}

bool combines(char32_t c) { return (c >= 0x300 && c <= 0x36f) || (c >= 0x20d0 && c <= 0x20ff); }

/// Whether the font's tables lie within the file: stb_truetype reads them without asking.
bool is_whole(const std::vector<unsigned char>& file) {
  const auto number = [&](std::size_t at, int bytes) {
    std::size_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | file[at + std::size_t(i)];
    return value;
  };
  constexpr std::size_t header = 12, record = 16;
  if (file.size() < header || file.size() < header + record * number(4, 2)) return false;
  for (std::size_t at = header; at < header + record * number(4, 2); at += record)
    if (number(at + 8, 4) + number(at + 12, 4) > file.size()) return false;
  return true;
}

}  // namespace

struct Font::Face {
  explicit Face(const char* name) {
    const std::string path = fmt::format(BYHAND_FONTS "/{}", name);
    std::ifstream in(path, std::ios::binary);
    data.assign(std::istreambuf_iterator<char>(in), {});
    if (!is_whole(data) || !stbtt_InitFont(&info, data.data(), 0))
      throw EnvironmentError(
          fmt::format("There is no whole font at {}: apt install --reinstall fonts-dejavu-core.", path));
  }

  double scale(double size) const { return stbtt_ScaleForMappingEmToPixels(&info, float(size)); }

  std::vector<unsigned char> data;
  stbtt_fontinfo info{};
};

Font::Font()
    : regular_(std::make_unique<Face>("DejaVuSans.ttf")), bold_(std::make_unique<Face>("DejaVuSans-Bold.ttf")) {}
Font::~Font() = default;

Font::Line Font::lay_out(std::string_view text, double size, const Face& face) {
  Line line;
  double& pen = line.width;
  double shift = 0, factor = 1;
  enum class Group { none, one, braces } group = Group::none;
  int previous = 0;
  struct Box {
    double left, right, top;
  } base{};  // of the last base letter, in pixels
  while (!text.empty()) {
    char32_t c = next_code_point(text);
    if (group == Group::braces && c == U'}') {
      group = Group::none, factor = 1, shift = 0;
      continue;
    }
    if (group == Group::none && (c == U'_' || c == U'^') && !text.empty()) {
      factor = small, shift = (c == U'^' ? raise : -lower) * size, previous = 0;
      group = text.front() == '{' ? Group::braces : Group::one;
      if (group == Group::braces) text.remove_prefix(1);
      continue;
    }
    if (c == U'\\' && !text.empty()) c = next_code_point(text);

    const int glyph = stbtt_FindGlyphIndex(&face.info, int(c));
    const double scale = face.scale(size * factor);
    int advance = 0, bearing = 0, x0 = 0, y0 = 0, x1 = 0, y1 = 0;
    stbtt_GetGlyphHMetrics(&face.info, glyph, &advance, &bearing);
    stbtt_GetGlyphBox(&face.info, glyph, &x0, &y0, &x1, &y1);
    if (combines(c)) {
      // Centres the mark over its letter and lifts it above tall letters: fonts place it for small ones.
      int small_top = 0, unused = 0;
      stbtt_GetCodepointBox(&face.info, 'x', &unused, &unused, &unused, &small_top);
      const double up = std::max(0.0, base.top - scale * small_top);
      line.letters.push_back({glyph, (base.left + base.right - scale * (x0 + x1)) / 2, shift + up, size * factor});
    } else {
      if (previous) pen += scale * stbtt_GetGlyphKernAdvance(&face.info, previous, glyph);
      base = {pen + scale * x0, pen + scale * x1, scale * y1};
      line.letters.push_back({glyph, pen, shift, size * factor});
      pen += scale * advance;
      previous = glyph;
    }
    // A combining mark after a single raised letter belongs to it.
    std::string_view rest = text;
    if (group == Group::one && (rest.empty() || !combines(next_code_point(rest))))
      group = Group::none, factor = 1, shift = 0, previous = 0;
  }
  return line;
}

double Font::width(std::string_view line, double size, bool bold) const {
  return lay_out(line, size, bold ? *bold_ : *regular_).width;
}

const Font::AtlasGlyph& Font::slot(const Face& face, bool bold, int glyph, double size, int phase, int halo) {
  const int steps = int(std::lround(size * size_steps));
  const auto [found, fresh] = slots_.try_emplace({bold, glyph, steps, phase, halo});
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
  const Face& face = bold ? *bold_ : *regular_;
  // Rotated by 90° anticlockwise, right becomes up and up becomes left.
  const double along = upright ? at.x() : -at.y(), down = upright ? at.y() : at.x();
  for (const PlacedGlyph& letter : lay_out(line, size, face).letters) {
    const double x = along + letter.x;
    const double column = std::floor(x + 0.5 / phases);
    const int phase = std::clamp(int(std::floor((x - column) * phases + 0.5)), 0, phases - 1);
    const AtlasGlyph& s = slot(face, bold, letter.glyph, letter.size, phase, int(std::lround(halo * size_steps)));
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
