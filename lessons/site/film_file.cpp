#include "lessons/site/film_file.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <memory>

#include "lessons/page/html/drawn.hpp"
#include "lessons/page/html/markup.hpp"
#include "renderer/data_url.hpp"
#include "renderer/opengl/space_image.hpp"
#include "renderer/png.hpp"

namespace byhand::site {
namespace {

/// When its pictures are shown.
struct Times {
  int pictures;
  double each;  // how long one is shown [s]

  Times(const course::Sequence& film, int most) {
    constexpr double rate = 15, step_rate = 3;  // pictures a second
    if (const auto* seconds = std::get_if<course::Seconds>(&film.length)) {
      pictures = std::clamp(static_cast<int>(std::lround(seconds->value * rate)), 2, most);
      each = seconds->value / (pictures - 1);
    } else {
      pictures = std::max(1, std::get<course::Frames>(film.length).value);
      each = 1 / step_rate;
    }
  }
};

renderer::SvgCanvas::DrawWindow half_as_fine() {
  return [canvas = std::shared_ptr<renderer::PixelCanvas>()](const auto& window, const auto& page,
                                                             auto paper) mutable {
    if (!canvas) canvas = std::make_shared<renderer::PixelCanvas>(page.width / 2, page.height / 2);
    return renderer::data_url(encode_png(renderer::space_image(*canvas, window, page, paper)));
  };
}

}  // namespace

std::string film_file(const course::Sequence& film, int most) {
  const Times times(film, most);
  const bool by_steps = std::holds_alternative<course::Frames>(film.length);
  const double pause = 1, all = (times.pictures - 1) * times.each + pause;  // [s]: at its end, and of one round
  // Each picture is shown from its time on and hidden again; the last stays for the pause.
  std::string file = fmt::format(
      "<svg xmlns=\"http://www.w3.org/2000/svg\" viewBox=\"0 0 1280 720\"><title>{}</title><style>"
      "svg svg{{visibility:hidden;animation:shown {:.3f}s step-end infinite}}"
      "svg svg:last-child{{animation-name:last}}"
      "@keyframes shown{{0%{{visibility:visible}}{:.4f}%{{visibility:hidden}}}}"
      "@keyframes last{{0%{{visibility:visible}}{:.4f}%{{visibility:hidden}}}}</style>\n",
      escaped(plain_text(film.caption)), all, 100 * times.each / all, 100 * pause / all);
  const renderer::SvgCanvas::DrawWindow in_space = half_as_fine();
  course::FrameDrawing draw = film.draw;
  for (int i = 0; i < times.pictures; ++i) {
    const auto picture = [&](renderer::Canvas& canvas) { draw(canvas, by_steps ? i : i * times.each); };
    const std::string svg = drawn(fmt::format("{}-{}", film.name, i), picture, in_space);
    file += fmt::format("<svg style=\"animation-delay:{:.3f}s\"{}\n", i * times.each, svg.substr(4));
  }
  return file + "</svg>\n";
}

}  // namespace byhand::site
