#include "lessons/tutor/terminal_view.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lessons/tutor/terminal_picture.hpp"
#include "lessons/tutor/terminal_text.hpp"

namespace byhand::tutor {

Style terminal_style() {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const char* const no_colour = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool colours =
      isatty(STDOUT_FILENO) && !(no_colour && *no_colour) && terminal && std::string_view(terminal) != "dumb";
  // Lines longer than 80 columns are hard to read, and shorter than 40 break formulas. An animation moves the
  // cursor up by the height of a picture, so a picture must fit on the screen.
  return {std::clamp<int>(known ? size.ws_col : 80, 40, 80), colours,
          std::clamp<int>(known ? size.ws_row - 2 : 22, 8, 22)};
}

void TerminalView::show(const Item& item) {
  if (const auto* figure = std::get_if<Figure>(&item)) {
    fmt::print("{}", item_text(*figure, style_));
    std::fflush(stdout);
    if (style_.colours && std::holds_alternative<Drawing>(figure->picture))
      fmt::print("{}\n", terminal_picture(small_.draw(*figure), style_.width, style_.picture_rows));
    pictures_.write(*figure);
    fmt::print("{}", caption_text(figure->caption, pictures_.path(*figure), style_));
  } else if (const auto* sequence = std::get_if<Sequence>(&item)) {
    if (style_.colours) play(*sequence);
    pictures_.write(*sequence);
    fmt::print("{}", caption_text(sequence->caption, pictures_.path(*sequence), style_));
  } else {
    std::visit(
        [&](const auto& it) {
          if constexpr (requires { item_text(it, style_); }) fmt::print("{}", item_text(it, style_));
        },
        item);
  }
  std::fflush(stdout);
}

/// Plays the animation: ten pictures a second, or two if its length is a number of frames. Enter skips to the end.
void TerminalView::play(const Sequence& sequence) {
  const bool counted = std::holds_alternative<Frames>(sequence.length);
  const int frames = small_.count(sequence);
  const double last = small_.time(sequence, frames - 1);
  const int pictures = counted ? frames : static_cast<int>(last * 10) + 1;
  FrameDrawing draw = sequence.draw;
  bool skipped = false;
  for (int i = 0; i < pictures; ++i) {
    if (skipped && i + 1 < pictures) continue;
    const double time = i + 1 == pictures ? last : counted ? i : i / 10.0;
    const std::string picture = terminal_picture(small_.draw(draw, time), style_.width, style_.picture_rows);
    if (i > 0) fmt::print("\033[{}A\r", std::count(picture.begin(), picture.end(), '\n') + 1);
    fmt::print("{}\n", picture);
    std::fflush(stdout);
    if (!skipped && i + 1 < pictures && keyboard_.pressed_within(counted ? 500 : 100)) {
      skipped = true;
      if (!keyboard_.line()) return;
      fmt::print("\033[A");
    }
  }
}

}  // namespace byhand::tutor
