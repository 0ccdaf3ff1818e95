#include "lessons/pictures/acts.hpp"

#include <algorithm>
#include <array>

namespace byhand::pictures {

using namespace renderer;

std::string wrapped(const Canvas& canvas, const std::string& text, double width, const TextStyle& style) {
  std::string all, line;
  for (std::size_t begin = 0; begin < text.size();) {
    const std::size_t end = std::min(text.find(' ', begin), text.size());
    const std::string word = text.substr(begin, end - begin), longer = line.empty() ? word : line + " " + word;
    if (!line.empty() && canvas.measure({0, 0}, longer, style).width > width) {
      all += line + "\n";
      line = word;
    } else {
      line = longer;
    }
    begin = end + 1;
  }
  return all + line;
}

double eased(double share) {
  const double s = std::clamp(share, 0.0, 1.0);
  return s * s * (3 - 2 * s);
}

double Acts::share(std::size_t i, double time) const {
  return eased((time - static_cast<double>(i) * (moving + holding)) / moving);
}

std::size_t Acts::now(double time) const {
  return std::min(acts_.size() - 1, static_cast<std::size_t>(std::max(0.0, time) / (moving + holding)));
}

void Acts::draw(Canvas& canvas, const Rectangle& frame, double time) const {
  const Camera before = canvas.camera();
  canvas.look_at_page();
  const std::size_t present = now(time);
  // On a narrow page there is room for the present one alone.
  constexpr double least = 90;
  const bool alone = frame.height < least * static_cast<double>(acts_.size());
  const std::size_t first = alone ? present : 0, end = alone ? present + 1 : acts_.size();
  const double height = frame.height / static_cast<double>(end - first);
  for (std::size_t i = first; i < end; ++i) {
    const bool comes = i > present;
    const double top = frame.top() - static_cast<double>(i - first) * height;
    // What is to come is pale; its contrast is that of decoration, for it is not to be read yet.
    const auto tone = [&](Colour c) { return comes ? palette::grid : c; };
    if (i == present) canvas.rectangle({frame.x, top - height + 14, 5, height - 18}, {acts_[i].colour, {{}, 0}});
    TextStyle style{.size = 22, .colour = tone(acts_[i].colour), .anchor = Anchor::top_left, .bold = i == present};
    const double width = canvas.measure({0, 0}, acts_[i].formula, style).width;
    style.size *= std::min(1.0, (frame.width - 20) / width);
    canvas.text({frame.x + 18, top - 8}, acts_[i].formula, style);
    const TextStyle small{.size = 17, .colour = tone(palette::ink), .anchor = Anchor::top_left};
    canvas.text({frame.x + 18, top - 42}, wrapped(canvas, acts_[i].words, frame.width - 24, small), small);
  }
  canvas.look(before);
}

void draw_growing(Canvas& canvas, const Point& from, const Point& by, double share, const Stroke& stroke) {
  if (share > 0 && by.norm() > 0) canvas.arrow(from, from + share * by, stroke);
}

void draw_right_angle(Canvas& canvas, const Point& corner, const Point& one, const Point& other, double side) {
  const double length = side / canvas.camera().scale;
  const Point a = length * one.normalized(), b = length * other.normalized();
  canvas.path(std::array<Point, 3>{corner + a, corner + a + b, corner + b}, {palette::muted, 1.6});
}

}  // namespace byhand::pictures
