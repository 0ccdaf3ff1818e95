#include "lessons/terminal/terminal_view.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cstdio>
#include <sstream>
#include <string>

#include "lessons/page/words.hpp"
#include "lessons/terminal/terminal_picture.hpp"
#include "lessons/terminal/terminal_text.hpp"
#include "renderer/chart.hpp"
#include "renderer/frames.hpp"

namespace byhand::course {
namespace {

constexpr double characters_rate = 10, counted_rate = 2;  // pictures a second of a film

/// A film's length, and how it is told.
struct Film {
  int pictures;
  double rate;
  double time(int picture) const { return counted ? picture : std::min(picture / characters_rate, last); }
  bool counted;
  double last;
};

Film film_of(const Sequence& sequence) {
  if (const auto* frames = std::get_if<Frames>(&sequence.length))
    return {std::max(1, frames->value), counted_rate, true, std::max(1, frames->value) - 1.0};
  const double last = std::get<Seconds>(sequence.length).value;
  return {static_cast<int>(last * characters_rate) + 2, characters_rate, false, last};
}

bool is_chart(const Item& item) {
  const auto* figure = std::get_if<Figure>(&item);
  return figure && chart_of(*figure);
}

void draw(renderer::Canvas& canvas, const Item& item) {
  canvas.clear();
  if (const auto* sequence = std::get_if<Sequence>(&item)) {
    FrameDrawing last = sequence->draw;
    last(canvas, film_of(*sequence).last);
    return;
  }
  const auto& figure = std::get<Figure>(item);
  if (const auto* chart = chart_of(figure))
    renderer::draw(canvas, *chart, canvas.page().inset(12));
  else
    std::get<Drawing>(figure.picture)(canvas);
}

std::string beside(const std::string& left, const std::string& right, int width) {
  std::istringstream lefts(left), rights(right);
  std::string all, l, r;
  while (true) {
    const bool has_left = static_cast<bool>(std::getline(lefts, l)),
               has_right = static_cast<bool>(std::getline(rights, r));
    if (!has_left && !has_right) return all;
    all += padded(has_left ? l : "", width) + (has_right ? r : "") + "\n";
  }
}

}  // namespace

std::string TerminalView::characters(const Item& item, const Style& style, int columns) {
  if (is_chart(item)) {
    Style narrow = style;
    narrow.width = columns;
    return item_text(std::get<Figure>(item), narrow);
  }
  // Eight times as many pixels across as dots, for 80 columns.
  if (!for_characters_) for_characters_.emplace(640, 360).list_labels();
  draw(*for_characters_, item);
  return character_picture(*for_characters_, columns, style);
}

renderer::Image TerminalView::image(const Item& item) {
  if (!for_images_) for_images_.emplace(1280, 720);
  draw(*for_images_, item);
  return for_images_->image();
}

std::string TerminalView::picture(const Item& item, const Style& style, int columns) {
  if (style.plain) return is_chart(item) ? item_text(std::get<Figure>(item), style) : "";
  if (style.colours && shows_images()) return image_sequence(image(item), columns, picture_rows(columns));
  return characters(item, style, is_chart(item) ? style.width : columns);
}

std::string TerminalView::caption(const Item& item, const Style& style) const {
  if (const auto* figure = std::get_if<Figure>(&item))
    return caption_text(figure->caption, pictures_.path(*figure), style);
  const auto& sequence = std::get<Sequence>(item);
  return caption_text(sequence.caption, pictures_.path(sequence), style);
}

void TerminalView::write(const Item& item) {
  if (const auto* figure = std::get_if<Figure>(&item))
    pictures_.write(*figure);
  else
    pictures_.write(std::get<Sequence>(item));
}

void TerminalView::show(const std::shared_ptr<const Item>& item) {
  const auto* sequence = std::get_if<Sequence>(item.get());
  if (!sequence && !std::holds_alternative<Figure>(*item)) {
    return screen_.show([item](const Style& style) {
      return std::visit(
          [&](const auto& it) {
            if constexpr (requires { item_text(it, style); })
              return item_text(it, style);
            else
              return std::string();
          },
          *item);
    });
  }
  const Style now = screen_.style();
  if (sequence && now.cursor && !now.plain) play(*sequence);
  const bool real = now.colours && !now.plain && shows_images();
  screen_.show([this, item](const Style& style) { return picture(*item, style, picture_columns(style)); },
               real ? picture_rows(picture_columns(now)) : 0);
  write(*item);
  screen_.show([this, item](const Style& style) { return caption(*item, style); });
}

void TerminalView::compare(const std::shared_ptr<const Item>& before, const std::shared_ptr<const Item>& now) {
  write(*now);
  screen_.show([this, before, now](const Style& style) {
    const auto headed = [&](const std::string& words) { return toned("  " + words, Tone::quiet, style) + "\n"; };
    if (style.plain)
      return headed("before") + picture(*before, style, 0) + headed("now") + picture(*now, style, 0) +
             caption(*now, style);
    const int half = style.width / 2;
    constexpr int narrowest = 38;  // of a chart whose numbers can be read
    if (half < narrowest)
      return headed("before") + characters(*before, style, style.width) + headed("now") +
             characters(*now, style, style.width) + caption(*now, style);
    return beside(headed("before") + characters(*before, style, half - 1),
                  headed("now") + characters(*now, style, half - 1), half) +
           caption(*now, style);
  });
}

/// Plays the film in characters, which it then removes. Space pauses, Enter skips the rest.
void TerminalView::play(const Sequence& sequence) {
  const Film film = film_of(sequence);
  const Style style = screen_.style();
  const int columns = picture_columns(style), rows = picture_rows(columns);
  screen_.make_room(rows + 1);
  fmt::print("{}", toned(fmt::format("  A film of {} s: Space pauses, Enter skips.",
                                     number(film.pictures / film.rate, 2)),
                         Tone::quiet, style) +
                       "\n");
  if (!for_characters_) for_characters_.emplace(640, 360).list_labels();
  FrameDrawing draw = sequence.draw;
  for (int i = 0; i < film.pictures; ++i) {
    for_characters_->clear();
    draw(*for_characters_, film.time(i));
    if (i > 0) fmt::print("\033[{}A", rows);
    std::istringstream lines(character_picture(*for_characters_, columns, style));
    for (std::string line; std::getline(lines, line);) fmt::print("{}\033[K\n", line);
    std::fflush(stdout);
    Key key = keyboard_.key_within(static_cast<int>(1000 / film.rate));
    if (key == Key::space) {
      do key = keyboard_.key_within(-1);
      while (key == Key::other);
    }
    if (key == Key::enter || key == Key::ended) {
      fmt::print("\033[{}A", rows);
      break;
    }
    if (i + 1 == film.pictures) fmt::print("\033[{}A", rows);
  }
  fmt::print("\033[A\r\033[J");
  std::fflush(stdout);
}

}  // namespace byhand::course
