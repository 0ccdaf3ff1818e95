#include "lessons/terminal/terminal_picture.hpp"

#include <chafa.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <cmath>
#include <cstdlib>
#include <memory>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/terminal/braille.hpp"

namespace byhand::course {
namespace {

using renderer::Colour;
using renderer::Image;
using renderer::Label;

template <auto release>
struct Release {
  template <class T>
  void operator()(T* object) const {
    release(object);
  }
};
template <class T, auto release>
using Owned = std::unique_ptr<T, Release<release>>;

int spread(const Colour& c) { return std::max({c.r, c.g, c.b}) - std::min({c.r, c.g, c.b}); }

/// The terminal's colour of this hue; its foreground (0) for greys, as ink would be lost on a dark background.
int terminal_colour(const Colour& c) {
  if (spread(c) < 48) return 0;
  const bool r = 2 * c.r > std::max({c.r, c.g, c.b}) + std::min({c.r, c.g, c.b});
  const bool g = 2 * c.g > std::max({c.r, c.g, c.b}) + std::min({c.r, c.g, c.b});
  const bool b = 2 * c.b > std::max({c.r, c.g, c.b}) + std::min({c.r, c.g, c.b});
  return 30 + (r ? 1 : 0) + (g ? 2 : 0) + (b ? 4 : 0);
}

/// How far a pixel is from the paper, 0 … 1.
double ink(const std::uint8_t* pixel) {
  const Colour paper = renderer::palette::paper;
  return std::max({std::abs(pixel[0] - paper.r), std::abs(pixel[1] - paper.g), std::abs(pixel[2] - paper.b)}) /
         255.0;
}

struct Dot {
  double darkest = 0;
  Colour colour{};  // of the darkest pixel
};

/// The pixel of the image under a dot that differs most from the paper.
Dot dot_at(const Image& image, int x, int y, int across, int down) {
  Dot dot;
  for (int py = y * image.height / down; py < std::max((y + 1) * image.height / down, y * image.height / down + 1);
       ++py)
    for (int px = x * image.width / across; px < (x + 1) * image.width / across; ++px) {
      const std::uint8_t* const pixel = image.pixel(px, py);
      const double here = ink(pixel);
      if (here > dot.darkest) dot = {here, {pixel[0], pixel[1], pixel[2]}};
    }
  return dot;
}

/// Lines are drawn whole; areas get dots that are the denser the darker they are.
bool is_set(double ink, int x, int y) {
  if (ink > 0.42) return true;
  if (ink > 0.24) return (x + 2 * y) % 4 == 0;
  return ink > 0.08 && x % 2 == 0 && (y + x) % 4 == 0;
}

struct Cell {
  std::string sign = " ";
  int colour = 0;
  bool label = false;
};
using Cells = std::vector<std::vector<Cell>>;

Cell braille_cell(const Image& image, int column, int row, int columns, int rows) {
  unsigned set = 0;
  Dot strongest;
  for (int y = 0; y < dots_down; ++y)
    for (int x = 0; x < dots_across; ++x) {
      const int across = dots_across * column + x, down = dots_down * row + y;
      const Dot dot = dot_at(image, across, down, dots_across * columns, dots_down * rows);
      if (!is_set(dot.darkest, across, down)) continue;
      set |= braille_dot(x, y);
      // A coloured line that crosses a grey one keeps its colour.
      if (dot.darkest * (64 + spread(dot.colour)) > strongest.darkest * (64 + spread(strongest.colour)))
        strongest = dot;
    }
  if (set == 0) return {};
  return {braille(set), terminal_colour(strongest.colour)};
}

std::vector<std::string> characters(std::string_view words) {
  std::vector<std::string> all;
  for (const char c : words) {
    const bool continues = (c & 0xC0) == 0x80;
    if (continues && !all.empty())
      all.back() += c;
    else
      all.emplace_back(1, c);
  }
  // A combining mark belongs to the letter before it.
  for (size_t i = 1; i < all.size();) {
    if (display_width(all[i]) > 0) {
      ++i;
      continue;
    }
    all[i - 1] += all[i];
    all.erase(all.begin() + static_cast<long>(i));
  }
  return all;
}

/// Writes the label where its text would be, or a row above or below if another label is there.
void write_label(Cells& cells, const Label& label, double page_width, double page_height) {
  const int rows = static_cast<int>(cells.size()), columns = static_cast<int>(cells.front().size());
  std::vector<std::string> lines(1);
  for (const char c : without_markup(label.text)) c == '\n' ? lines.emplace_back() : lines.back() += c;
  const double middle = rows * (1 - label.box.centre().y() / page_height);
  for (size_t i = 0; i < lines.size(); ++i) {
    const std::vector<std::string> letters = characters(lines[i]);
    const int width = static_cast<int>(letters.size());
    if (width == 0 || width > columns) continue;
    const int wanted = static_cast<int>(std::floor(middle + double(i) - 0.5 * double(lines.size() - 1)));
    const int start =
        std::clamp(static_cast<int>(std::lround(columns * label.box.centre().x() / page_width - 0.5 * width)), 0,
                   columns - width);
    const auto is_free = [&](int row) {
      if (row < 0 || row >= rows) return false;
      for (int x = std::max(0, start - 1); x < std::min(columns, start + width + 1); ++x)
        if (cells[row][x].label) return false;
      return true;
    };
    for (const int row : {wanted, wanted - 1, wanted + 1}) {
      if (!is_free(row)) continue;
      for (int x = 0; x < width; ++x)
        cells[row][start + x] = {letters[static_cast<size_t>(x)], terminal_colour(label.colour), true};
      break;
    }
  }
}

std::string printed(const Cells& cells, const Style& style) {
  std::string text;
  for (const auto& row : cells) {
    std::string line;
    int colour = 0;
    const auto end =
        std::find_if(row.rbegin(), row.rend(), [](const Cell& cell) { return cell.sign != " "; }).base();
    for (auto cell = row.begin(); cell != end; ++cell) {
      if (style.colours && cell->colour != colour)
        line += cell->colour ? "\033[" + std::to_string(cell->colour) + "m" : "\033[39m";
      colour = cell->colour;
      line += cell->sign;
    }
    if (style.colours && colour) line += "\033[39m";
    text += line + "\n";
  }
  return text;
}

const ChafaTermInfo* terminal() {
  static const Owned<ChafaTermInfo, chafa_term_info_unref> info(
      chafa_term_db_detect(chafa_term_db_get_default(), environ));
  return info.get();
}

ChafaPixelMode pixel_mode() {
  const auto has = [](ChafaTermSeq sequence) { return chafa_term_info_have_seq(terminal(), sequence); };
  if (has(CHAFA_TERM_SEQ_BEGIN_KITTY_IMMEDIATE_IMAGE_V1)) return CHAFA_PIXEL_MODE_KITTY;
  if (has(CHAFA_TERM_SEQ_BEGIN_ITERM2_IMAGE)) return CHAFA_PIXEL_MODE_ITERM2;
  if (has(CHAFA_TERM_SEQ_BEGIN_SIXELS)) return CHAFA_PIXEL_MODE_SIXELS;
  return CHAFA_PIXEL_MODE_SYMBOLS;
}

}  // namespace

std::string without_markup(std::string_view label) {
  static constexpr std::string_view plain = "0123456789+-=()aeoxhklmnpstijruvxT";
  static const std::vector<std::string> lowered = characters("₀₁₂₃₄₅₆₇₈₉₊₋₌₍₎ₐₑₒₓₕₖₗₘₙₚₛₜᵢⱼᵣᵤᵥₓT");
  static const std::vector<std::string> raised = characters("⁰¹²³⁴⁵⁶⁷⁸⁹⁺⁻⁼⁽⁾ᵃᵉᵒˣʰᵏˡᵐⁿᵖˢᵗⁱʲʳᵘᵛˣᵀ");
  std::string words;
  for (size_t i = 0; i < label.size(); ++i) {
    const char c = label[i];
    if (c == '\\' && i + 1 < label.size()) {
      words += label[++i];
      continue;
    }
    if ((c != '_' && c != '^') || i + 1 == label.size()) {
      words += c;
      continue;
    }
    const size_t close = label[i + 1] == '{' ? label.find('}', i) : std::string_view::npos;
    const std::string_view inside =
        close == std::string_view::npos ? label.substr(i + 1, 1) : label.substr(i + 2, close - i - 2);
    const bool has_all =
        inside.find_first_not_of(c == '_' ? plain.substr(0, plain.size() - 1) : plain) == std::string_view::npos;
    if (!has_all && inside.size() == 1 && (inside.front() & 0x80) != 0) continue;  // "_λ": the letter follows
    if (!has_all)
      words += (c == '^' ? "^" : "") + std::string(inside);
    else
      for (const char letter : inside) words += (c == '_' ? lowered : raised)[plain.find(letter)];
    i = close == std::string_view::npos ? i + 1 : close;
  }
  return words;
}

int picture_rows(int columns) { return std::max(1, static_cast<int>(std::lround(columns * 9.0 / 32))); }

int picture_columns(const Style& style) {
  int columns = style.width - 2;
  while (columns > 20 && picture_rows(columns) > style.rows - 6) --columns;
  return columns;
}

std::string character_picture(renderer::PixelCanvas& canvas, int columns, const Style& style) {
  const int rows = picture_rows(columns);
  const Image image = canvas.image();
  Cells cells(static_cast<size_t>(rows), std::vector<Cell>(static_cast<size_t>(columns)));
  for (int row = 0; row < rows; ++row)
    for (int column = 0; column < columns; ++column)
      cells[static_cast<size_t>(row)][static_cast<size_t>(column)] =
          braille_cell(image, column, row, columns, rows);
  const auto page = canvas.page();
  for (const Label& label : canvas.labels()) write_label(cells, label, page.width, page.height);
  return printed(cells, style);
}

bool shows_images() { return pixel_mode() != CHAFA_PIXEL_MODE_SYMBOLS; }

std::string image_sequence(const Image& image, int columns, int rows) {
  // A terminal may say anything of its size; no letter is larger than this.
  constexpr int least = 2, most = 64;
  winsize size{};
  const bool told = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
  const int width = told ? size.ws_xpixel / size.ws_col : 0, height = told ? size.ws_ypixel / size.ws_row : 0;
  const bool known = std::min(width, height) >= least && std::max(width, height) <= most;
  const Owned<ChafaCanvasConfig, chafa_canvas_config_unref> config(chafa_canvas_config_new());
  chafa_canvas_config_set_geometry(config.get(), columns, rows);
  chafa_canvas_config_set_pixel_mode(config.get(), pixel_mode());
  chafa_canvas_config_set_cell_geometry(config.get(), known ? width : 10, known ? height : 20);
  const Owned<ChafaCanvas, chafa_canvas_unref> canvas(chafa_canvas_new(config.get()));
  chafa_canvas_draw_all_pixels(canvas.get(), CHAFA_PIXEL_RGB8, image.rgb.data(), image.width, image.height,
                               3 * image.width);
  GString* const printed = chafa_canvas_print(canvas.get(), const_cast<ChafaTermInfo*>(terminal()));
  std::string text(printed->str, printed->len);
  g_string_free(printed, TRUE);
  if (!text.ends_with('\n')) text += '\n';
  return text;
}

}  // namespace byhand::course
