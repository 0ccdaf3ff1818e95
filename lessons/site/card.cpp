#include "lessons/site/card.hpp"

#include <cmath>
#include <optional>
#include <variant>

#include "lessons/files/atomic_file.hpp"
#include "lessons/files/picture_drawer.hpp"
#include "lessons/page/html/drawn.hpp"
#include "renderer/opengl/space_picture.hpp"
#include "renderer/png.hpp"

namespace byhand::site {
namespace {

using namespace course;

std::optional<Figure> first_drawing(const std::vector<RecordedStep>& steps) {
  std::optional<Figure> film, chart;
  for (const RecordedStep& step : steps)
    for (const Item& item : step.page.items()) {
      if (const auto* figure = std::get_if<Figure>(&item)) {
        if (std::holds_alternative<Drawing>(figure->picture)) return *figure;
        if (!chart && std::holds_alternative<renderer::Chart>(figure->picture)) chart = *figure;
      }
      if (const auto* sequence = std::get_if<Sequence>(&item); sequence && !film) {
        const auto* seconds = std::get_if<Seconds>(&sequence->length);
        const double middle =
            seconds ? seconds->value / 2 : std::floor(0.5 * std::get<Frames>(sequence->length).value);
        film = Figure{sequence->name, sequence->caption,
                      [draw = sequence->draw, middle](renderer::Canvas& canvas) { draw(canvas, middle); }};
      }
    }
  return film ? film : chart;
}

std::string without_letters(std::string svg) {
  constexpr std::string_view begin = "<text", end = "</text>";
  for (auto at = svg.find(begin); at != std::string::npos; at = svg.find(begin, at))
    svg.erase(at, svg.find(end, at) + end.size() - at);
  return svg;
}

}  // namespace

void write_card(const std::vector<RecordedStep>& steps, const std::filesystem::path& folder) {
  const std::optional<Figure> picture = first_drawing(steps);
  if (!picture) return;
  course::write_whole(folder / "card.svg", without_letters(drawn(*picture, renderer::space_picture_url)));
  PictureDrawer drawer({"share", 640, 360, 30});
  course::write_whole(folder / "card.png",
                      renderer::encode_png(drawer.draw(*picture), renderer::Compression::thorough));
}

}  // namespace byhand::site
