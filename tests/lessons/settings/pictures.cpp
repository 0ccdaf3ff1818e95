#include "tests/lessons/settings/pictures.hpp"

#include <algorithm>

namespace byhand::tests {

bool is_blank(const renderer::Image& image) {
  int different = 0;
  for (int y = 0; y < image.height; ++y)
    for (int x = 0; x < image.width; ++x)
      different += !std::equal(image.pixel(x, y), image.pixel(x, y) + 3, image.pixel(0, 0));
  return different * 1000 < image.width * image.height;
}

std::vector<Finding> blank_pictures(const course::Page& page, course::PictureDrawer& pictures) {
  std::vector<Finding> found;
  const auto look_at = [&](const renderer::Image& image, const std::string& caption) {
    if (is_blank(image)) found.push_back({"a blank picture", caption});
  };
  for (const course::Item& item : page.items()) {
    if (const auto* figure = std::get_if<course::Figure>(&item))
      if (!std::holds_alternative<course::TimedChart>(figure->picture))
        look_at(pictures.draw(*figure), figure->caption);
    if (const auto* sequence = std::get_if<course::Sequence>(&item)) {
      const course::FrameDrawing draw = sequence->draw;
      const int last = pictures.count(*sequence) - 1;
      for (const int frame : {0, last / 2, last})
        look_at(pictures.draw(draw, pictures.time(*sequence, frame)), sequence->caption);
    }
  }
  return found;
}

}  // namespace byhand::tests
