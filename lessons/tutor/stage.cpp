#include "lessons/tutor/stage.hpp"

#include <fmt/format.h>
#include <sys/ioctl.h>
#include <unistd.h>

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <string>
#include <string_view>

#include "lessons/tutor/speech.hpp"
#include "lessons/tutor/terminal_picture.hpp"

namespace byhand::tutor {

Style terminal_style() {
  winsize size{};
  const bool known = ioctl(STDOUT_FILENO, TIOCGWINSZ, &size) == 0 && size.ws_col > 0;
  const char* const no_colour = std::getenv("NO_COLOR");
  const char* const terminal = std::getenv("TERM");
  const bool colours =
      isatty(STDOUT_FILENO) && !(no_colour && *no_colour) && terminal && std::string_view(terminal) != "dumb";
  // Longer lines than 80 columns are hard to read, shorter ones than 40 break formulas.
  // A picture must fit above the cursor, or it cannot be played in place.
  return {std::clamp<int>(known ? size.ws_col : 80, 40, 80), colours,
          std::clamp<int>(known ? size.ws_row - 2 : 22, 8, 22)};
}

void Stage::show(const Item& item) {
  if (const auto* figure = std::get_if<Figure>(&item)) {
    fmt::print("{}", say(*figure, style_));
    std::fflush(stdout);
    if (style_.colours && std::holds_alternative<Drawing>(figure->picture))
      fmt::print("{}\n", terminal_picture(studio_.small(*figure), style_.width, style_.picture_rows));
    studio_.write(*figure);
    fmt::print("{}", say_caption(figure->caption, studio_.path(*figure), style_));
  } else if (const auto* sequence = std::get_if<Sequence>(&item)) {
    if (style_.colours) play(*sequence);
    studio_.write(*sequence);
    fmt::print("{}", say_caption(sequence->caption, studio_.path(*sequence), style_));
  } else {
    std::visit(
        [&](const auto& it) {
          if constexpr (requires { say(it, style_); }) fmt::print("{}", say(it, style_));
        },
        item);
  }
  std::fflush(stdout);
}

/// Plays a sequence in place, ten pictures a second or, where frames are counted, two; Enter jumps to its
/// end.
void Stage::play(const Sequence& sequence) {
  const bool counted = std::holds_alternative<Frames>(sequence.length);
  const int frames = studio_.count(sequence);
  const double last = studio_.time(sequence, frames - 1);
  const int pictures = counted ? frames : static_cast<int>(last * 10) + 1;
  FrameDrawing draw = sequence.draw;
  bool skipped = false;
  for (int i = 0; i < pictures; ++i) {
    if (skipped && i + 1 < pictures) continue;
    const double time = i + 1 == pictures ? last : counted ? i : i / 10.0;
    const std::string picture = terminal_picture(studio_.small(draw, time), style_.width, style_.picture_rows);
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
