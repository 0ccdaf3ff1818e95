#include "renderer/svg_canvas.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdint>
#include <iterator>
#include <unordered_map>
#include <utility>

#include "renderer/font.hpp"

namespace byhand::renderer {
namespace {

constexpr int svg_height = 720;  // points

/// Text between tags.
std::string escaped(std::string_view text) {
  std::string all;
  for (const char c : text) switch (c) {
      case '<': all += "&lt;"; break;
      case '>': all += "&gt;"; break;
      case '&': all += "&amp;"; break;
      case '"': all += "&quot;"; break;
      default: all += c;
    }
  return all;
}

// A hundredth of a point is the unit of coordinates: files stay small, and their bytes do not depend on rounding
// in the last digits. Halves, which layouts give often, round up also where they miss a little.
std::int64_t hundredths(double value) { return static_cast<std::int64_t>(std::floor(100 * value + 0.500001)); }

// "12.3", "-.05", "7"
void append(std::string& to, std::int64_t hundredths) {
  if (hundredths < 0) to += '-';
  const std::int64_t size = std::abs(hundredths), whole = size / 100, rest = size % 100;
  if (whole > 0 || rest == 0) to += std::to_string(whole);
  if (rest == 0) return;
  to += '.';
  to += static_cast<char>('0' + rest / 10);
  if (rest % 10 > 0) to += static_cast<char>('0' + rest % 10);
}

std::string decimal(double value) {
  std::string digits;
  append(digits, hundredths(value));
  return digits;
}

std::string attribute(std::string_view name, double value) {
  return fmt::format(" {}=\"{}\"", name, decimal(value));
}

// "#fcfbf7" or, if that is the same, "#fff"
std::string hexadecimal(Colour c) {
  const bool is_short = c.r % 17 == 0 && c.g % 17 == 0 && c.b % 17 == 0;
  return is_short ? fmt::format("#{:x}{:x}{:x}", c.r / 17, c.g / 17, c.b / 17)
                  : fmt::format("#{:02x}{:02x}{:02x}", c.r, c.g, c.b);
}

// `kind`: fill or stroke
std::string paint(std::string_view kind, Colour colour, double opacity = 1) {
  if (colour.a == 0) return fmt::format(" {}=\"none\"", kind);
  std::string both = fmt::format(" {}=\"{}\"", kind, hexadecimal(colour));
  opacity *= colour.a / 255.0;
  return opacity < 1 ? both + attribute(fmt::format("{}-opacity", kind), opacity) : both;
}

std::string pen_attributes(const Pen& pen, double opacity = 1) {
  if (pen.width <= 0 || pen.colour.a == 0) return "";
  std::string all = paint("stroke", pen.colour, opacity) + attribute("stroke-width", pen.width);
  if (pen.on > 0) all += fmt::format(" stroke-dasharray=\"{} {}\"", decimal(pen.on), decimal(pen.off));
  return all;
}

// The path through the points, as relative steps between rounded points; empty if they are all the same.
std::string path_data(std::span<const Point> points) {
  std::string data;
  std::int64_t x = 0, y = 0;
  char command = 0;
  const auto step = [&](char next, std::initializer_list<std::int64_t> numbers) {
    if (command != next) data += next;
    for (const std::int64_t number : numbers) {
      const char last = data.back();
      if (number >= 0 && last >= '0' && last <= '9') data += ' ';
      append(data, number);
    }
    command = next;
  };
  for (const Point& p : points) {
    const std::int64_t next_x = hundredths(p.x()), next_y = hundredths(p.y()), dx = next_x - x, dy = next_y - y;
    if (!command)
      step('M', {next_x, next_y});
    else if (dx != 0 && dy != 0)
      step('l', {dx, dy});
    else if (dx != 0)
      step('h', {dx});
    else if (dy != 0)
      step('v', {dy});
    x = next_x, y = next_y;
  }
  return command == 'M' ? "" : data;
}

}  // namespace

class SvgCanvas::Surface : public DrawingSurface {
 public:
  Surface(const PageSize& size, std::string name, DrawWindow draw_window)
      : size_(size), name_(std::move(name)), draw_window_(std::move(draw_window)) {}

  void clear(Colour paper) override {
    body_.clear(), run_ = {}, cells_ = {}, clips_.clear(), windows_.clear();
    clipped_ = false;
    paper_ = paper;
    height_ = size_.height;
  }

  void cut(int height) override { height_ = height; }

  void clip(const PixelBox& box) override {
    end_run();
    if (std::exchange(clipped_, box != PixelBox{0, 0, size_.width, size_.height})) body_ += "</g>";
    if (!clipped_) return;
    auto known = std::find(clips_.begin(), clips_.end(), box);
    if (known == clips_.end()) known = clips_.insert(known, box);
    body_ += fmt::format("<g clip-path=\"url(#{}-clip{})\">", name_, known - clips_.begin());
  }

  void polygon(std::span<const Point> corners, Colour fill, const Pen& edge, bool sharp) override {
    const std::string data = path_data(corners);
    if (data.empty() || (fill.a == 0 && edge.width <= 0)) return;
    if (sharp && edge.width <= 0)
      add_cell(corners, fill);
    else
      add(fmt::format("<path d=\"{}z\"", data), paint("fill", fill) + pen_attributes(edge));
  }

  void disc(const Point& centre, double radius, Colour fill, const Pen& edge) override {
    add("<circle" + attribute("cx", centre.x()) + attribute("cy", centre.y()) + attribute("r", radius),
        paint("fill", fill) + pen_attributes(edge));
  }

  void path(std::span<const Point> points, const Pen& pen) override {
    const auto line = [&](std::span<const Point> part, double opacity) {
      const std::string data = path_data(part);
      if (!data.empty()) add_line(data, " fill=\"none\"" + pen_attributes(pen, opacity));
    };
    if (pen.opacity_at_start == pen.opacity_at_end) return line(points, pen.opacity_at_end);
    // SVG has no gradient along a path: a few parts of one opacity each.
    const std::size_t segments = points.size() - 1, parts = std::min<std::size_t>(segments, 24);
    for (std::size_t i = 0; i < parts; ++i) {
      const std::size_t first = segments * i / parts, last = segments * (i + 1) / parts;
      const double share = static_cast<double>(first + last) / static_cast<double>(2 * segments);
      line(points.subspan(first, last - first + 1),
           pen.opacity_at_start + share * (pen.opacity_at_end - pen.opacity_at_start));
    }
  }

  void text(std::span<const TextLine> lines, const Lettering& how) override {
    for (const TextLine& line : lines) {
      if (line.words.empty()) continue;
      const std::string place = how.upright ? attribute("x", line.at.x()) + attribute("y", line.at.y())
                                            : fmt::format(" transform=\"translate({} {})rotate(-90)\"",
                                                          decimal(line.at.x()), decimal(line.at.y()));
      std::string look =
          attribute("font-size", how.size) + (how.bold ? " font-weight=\"bold\"" : "") + paint("fill", how.colour);
      if (how.halo > 0)
        look += paint("stroke", paper_) + attribute("stroke-width", 2 * how.halo) + " paint-order=\"stroke\"";
      // With its length given, a line keeps its place also where another font must do.
      add("<text" + place + attribute("textLength", text_width(line.words, how.size, how.bold)), look,
          ">" + spans(line.words, how.size) + "</text>");
    }
  }

  double text_width(std::string_view line, double size, bool bold) const override {
    return font_.width(line, size, bold);
  }

  void space(const Space& space, const PixelBox& frame) override {
    if (frame.width <= 0 || frame.height <= 0) return;
    windows_.push_back({space, frame});
    if (!draw_window_) return;
    end_run();
    body_ += fmt::format("<image x=\"{}\" y=\"{}\" width=\"{}\" height=\"{}\" href=\"{}\"/>", frame.x, frame.y,
                         frame.width, frame.height, draw_window_(windows_.back(), size_, paper_));
  }

  const std::vector<Window>& windows() const { return windows_; }

  std::string svg(std::string_view title, std::string_view description) const {
    std::string label = "aria-hidden=\"true\"";  // of a picture that is named by what surrounds it
    if (!title.empty())
      label = fmt::format("role=\"img\" aria-labelledby=\"{0}-title{1}\"", name_,
                          description.empty() ? "" : fmt::format(" {}-description", name_));
    std::string all = fmt::format(
        "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 {} {}\" {} "
        "font-family=\"'DejaVu Sans',sans-serif\" stroke-linejoin=\"round\" xml:space=\"preserve\">",
        size_.width, height_, label);
    if (!title.empty()) all += fmt::format("<title id=\"{}-title\">{}</title>", name_, escaped(title));
    if (!description.empty())
      all += fmt::format("<desc id=\"{}-description\">{}</desc>", name_, escaped(description));
    for (std::size_t i = 0; i < clips_.size(); ++i)
      all += fmt::format("<clipPath id=\"{}-clip{}\"><path d=\"{}\"/></clipPath>", name_, i, outline(clips_[i]));
    std::string sheet = outline({0, 0, size_.width, height_});
    if (!draw_window_)
      for (const Window& window : windows_) sheet += outline(window.frame);
    all += fmt::format("<path d=\"{}\"{} fill-rule=\"evenodd\"/>", sheet, paint("fill", paper_));
    return all + body_ + written() + (clipped_ ? "</g></svg>" : "</svg>");
  }

 private:
  // Neighbours that look alike: their common attributes are written once, in a group around them.
  struct Run {
    std::string look, alone, together;
    int size = 0;
    std::string lines = {};  // instead of elements: opaque lines, which are one path

    std::string written() const {
      if (!lines.empty()) return "<path d=\"" + lines + "\"" + look + "/>";
      return size > 1 ? "<g" + look + ">" + together + "</g>" : alone;
    }
  };

  // Cells of a map or bars, on whole pixels, none above another: those of one colour are one path.
  struct Cells {
    struct Path {
      std::string begin, outlines;
      PixelBox last{};
      std::size_t at = 0;  // where the last one's outline begins
    };
    std::vector<Path> paths;  // in the order in which their colours came
    std::unordered_map<std::string, std::size_t> by_begin;
    int top = 0, bottom = 0;  // of all rows but the last
    PixelBox row{};           // the last row so far

    /// Whether this cell follows in a row of its own height, or begins one beside all others.
    bool goes_on(const PixelBox& box) {
      if (paths.empty()) {
        row = box, top = bottom = box.y;
        return true;
      }
      if (box.y == row.y && box.height == row.height && box.x >= row.x + row.width) {
        row.width = box.x + box.width - row.x;
        return true;
      }
      const int above = std::min(top, row.y), below = std::max(bottom, row.y + row.height);
      if (box.y < below && box.y + box.height > above) return false;
      top = above, bottom = below, row = box;
      return true;
    }

    /// A cell that touches the last one of its colour in its row makes it wider.
    void add(const std::string& begin, PixelBox box) {
      const auto [known, is_new] = by_begin.try_emplace(begin, paths.size());
      if (is_new) paths.push_back({begin, {}, {}, 0});
      Path& path = paths[known->second];
      if (!is_new && box.y == path.last.y && box.height == path.last.height &&
          box.x == path.last.x + path.last.width) {
        box.x = path.last.x, box.width += path.last.width;
        path.outlines.resize(path.at);
      }
      path.at = path.outlines.size();
      path.outlines += outline(box);
      path.last = box;
    }

    std::string written() const {
      if (paths.empty()) return "";
      std::string all = "<g shape-rendering=\"crispEdges\">";
      for (const Path& path : paths) all += "<path" + path.begin + path.outlines + "\"/>";
      return all + "</g>";
    }
  };

  // An element of three parts; `look`: attributes that it would inherit from a group.
  void add(const std::string& begin, const std::string& look, const std::string& end = "/>") {
    if (look != run_.look || !run_.lines.empty() || !cells_.paths.empty()) end_run();
    run_.look = look;
    if (++run_.size == 1) run_.alone = begin + look + end;
    run_.together += begin + end;
  }

  void add_line(const std::string& data, const std::string& look) {
    if (look.find("opacity") != std::string::npos) return add("<path d=\"" + data + "\"", look);
    if (look != run_.look || run_.lines.empty() || !cells_.paths.empty()) end_run();
    run_.look = look;
    run_.lines += data;
  }

  void add_cell(std::span<const Point> corners, Colour fill) {
    const auto [left, right] = std::ranges::minmax(corners, {}, [](const Point& p) { return p.x(); });
    const auto [top, bottom] = std::ranges::minmax(corners, {}, [](const Point& p) { return p.y(); });
    const auto pixels = [](double length) { return static_cast<int>(std::lround(length)); };
    const PixelBox box{pixels(left.x()), pixels(top.y()), pixels(right.x() - left.x()),
                       pixels(bottom.y() - top.y())};
    if (!cells_.goes_on(box)) {
      end_run();
      cells_.goes_on(box);
    }
    cells_.add(paint("fill", fill) + " d=\"", box);
  }

  std::string written() const { return run_.written() + cells_.written(); }

  void end_run() {
    body_ += written();
    run_ = {}, cells_ = {};
  }

  static std::string outline(const PixelBox& box) {
    return fmt::format("M{} {}h{}v{}h{}z", box.x, box.y, box.width, box.height, -box.width);
  }

  // A line with its subscripts and superscripts.
  static std::string spans(std::string_view line, double size) {
    std::string all;
    double height = 0;     // of the baseline so far, in sizes
    bool leaning = false;  // the letter before
    for (const Font::Piece& piece : Font::pieces(line)) {
      const bool touches = leaning && piece.words.starts_with("ᵀ");  // which a J of a page's own font reaches
      const bool plain = piece.shift == height && piece.factor == 1 && !piece.italic && !touches;
      leaning = piece.italic;
      if (!plain) {
        all += "<tspan";
        if (touches) all += attribute("dx", 0.12 * size);
        if (piece.shift != height) all += attribute("dy", (height - piece.shift) * size);
        if (piece.italic) all += " font-style=\"italic\"";
        if (piece.factor != 1) all += attribute("font-size", piece.factor * size);
        all += ">";
      }
      all += escaped(piece.words) + (plain ? "" : "</tspan>");
      height = piece.shift;
    }
    return all;
  }

  PageSize size_;
  int height_ = size_.height;  // down to where the page is cut
  std::string name_;
  DrawWindow draw_window_;
  Font font_;
  std::string body_;
  Run run_;      // what follows it
  Cells cells_;  // and these
  std::vector<PixelBox> clips_;
  std::vector<Window> windows_;
  bool clipped_ = false;
  Colour paper_ = palette::paper;
};

SvgCanvas::SvgCanvas(int width, std::string name, DrawWindow draw_window)
    : Canvas({width, svg_height},
             std::make_unique<Surface>(PageSize(width, svg_height), std::move(name), std::move(draw_window))) {}

std::string SvgCanvas::svg(std::string_view title, std::string_view description) const {
  return static_cast<const Surface&>(surface()).svg(title, description);
}

const std::vector<SvgCanvas::Window>& SvgCanvas::windows() const {
  return static_cast<const Surface&>(surface()).windows();
}

}  // namespace byhand::renderer
