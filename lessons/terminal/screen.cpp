#include "lessons/terminal/screen.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string_view>
#include <utility>

namespace byhand::course {
namespace {

constexpr int prompt_rows = 4;  // a blank line, what can be typed, and the prompt

int rows_of(std::string_view lines) { return static_cast<int>(std::count(lines.begin(), lines.end(), '\n')); }

/// Cuts the first `rows` lines off `lines`.
std::string take_rows(std::string_view& lines, int rows) {
  size_t end = 0;
  for (; rows > 0 && end < lines.size(); --rows) end = std::min(lines.find('\n', end), lines.size() - 1) + 1;
  const std::string taken(lines.substr(0, end));
  lines.remove_prefix(end);
  return taken;
}

void write(std::string_view words) {
  std::fwrite(words.data(), 1, words.size(), stdout);
  std::fflush(stdout);
}

}  // namespace

Screen::Screen(Keyboard& keyboard, bool plain)
    : keyboard_(keyboard), plain_(plain), pages_(!plain && isatty(STDIN_FILENO) && isatty(STDOUT_FILENO)) {}

Style Screen::style() const {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0 && size.ws_row > 0;
  const char* const no_colour = std::getenv("NO_COLOR");
  Style style;
  // Lines longer than 100 columns are hard to read, and shorter than 40 break formulas.
  style.width = std::clamp<int>(known ? size.ws_col : 80, 40, 100);
  style.rows = std::clamp<int>(known ? size.ws_row : 24, 12, 500);
  style.cursor = keyboard_.edits_lines();
  style.colours = style.cursor && !(no_colour && *no_colour);
  style.plain = plain_;
  return style;
}

void Screen::pause() {
  const Style now = style();
  if (!now.cursor) {
    write("-- Enter turns the page --");
  } else {
    write(toned("-- Space turns the page --", Tone::quiet, now));
  }
  if (keyboard_.key_within(-1) == Key::ended) ended_ = true;
  if (now.cursor) write("\r\033[K");
  used_ = 0;
}

void Screen::print(const std::string& lines, int rows) {
  const int page = style().rows - prompt_rows;
  const bool fits = rows <= page;
  if (!pages_ || ended_ || used_ + rows <= page) return used_ += rows, write(lines);
  std::string_view rest = lines;
  if (fits || used_ > page / 2) {
    pause();
    rest.remove_prefix(std::min(rest.find_first_not_of('\n'), rest.size()));
  }
  while (rows_of(rest) > page - used_ && !ended_ && !fits) {
    write(take_rows(rest, page - used_));
    pause();
  }
  used_ += fits ? rows : rows_of(rest);
  write(rest);
}

void Screen::show(Block block, int rows) {
  const std::string lines = block(style());
  print(lines, rows > 0 ? rows : rows_of(lines));
  printed(std::move(block), rows);
}

void Screen::make_room(int rows) {
  if (pages_ && !ended_ && used_ > 0 && used_ + rows > style().rows - prompt_rows) pause();
}

void Screen::printed(Block block, int rows) { blocks_.push_back({std::move(block), rows}); }

void Screen::print_again() {
  const Style now = style();
  int room = now.rows - prompt_rows;
  std::string lines;
  for (auto shown = blocks_.rbegin(); shown != blocks_.rend() && room > 0; ++shown) {
    const std::string block = shown->block(now);
    const int rows = shown->rows > 0 ? shown->rows : rows_of(block);
    std::string_view end = block;
    if (rows > room && shown->rows > 0) break;
    if (rows > room) take_rows(end, rows - room);
    lines.insert(0, end);
    room -= rows;
  }
  write("\033[H\033[2J");
  write(lines);
}

std::optional<std::string> Screen::ask(const Block& above, const Block& prompt) {
  write(above(style()));
  printed(above, 0);
  keyboard_.on_resize([this] { print_again(); });
  const auto line = ended_ ? std::nullopt : keyboard_.line(prompt(style()));
  keyboard_.on_resize(nullptr);
  used_ = 0;
  if (line)
    printed(
        [prompt, typed = *line](const Style& style) {
          std::string visible = prompt(style) + typed + "\n";
          std::erase(visible, '\1');
          return visible;
        },
        0);
  return line;
}

}  // namespace byhand::course
