#include "lessons/files/picture_drawer.hpp"

#include <algorithm>
#include <cmath>

namespace byhand::course {

renderer::PixelCanvas& PictureDrawer::blank() {
  if (!canvas_) canvas_.emplace(quality_.width, quality_.height);
  canvas_->clear();
  return *canvas_;
}

renderer::Image PictureDrawer::draw(const Figure& figure) {
  renderer::PixelCanvas& canvas = blank();
  if (const auto* chart = chart_of(figure))
    renderer::draw(canvas, *chart, canvas.page().inset(12));
  else
    std::get<Drawing>(figure.picture)(canvas);
  return canvas.image();
}

renderer::Image PictureDrawer::draw(const FrameDrawing& frame, double time) {
  renderer::PixelCanvas& canvas = blank();
  frame(canvas, time);
  return canvas.image();
}

int PictureDrawer::count(const Sequence& sequence) const {
  if (const auto* frames = std::get_if<Frames>(&sequence.length)) return std::max(1, frames->value);
  return static_cast<int>(std::lround(std::get<Seconds>(sequence.length).value * quality_.rate)) + 1;
}

double PictureDrawer::time(const Sequence& sequence, int index) const {
  if (std::holds_alternative<Frames>(sequence.length)) return index;
  return static_cast<double>(index) / quality_.rate;
}

double PictureDrawer::rate(const Sequence& sequence) const {
  if (std::holds_alternative<Seconds>(sequence.length)) return quality_.rate;
  constexpr double each = 0.8, longest = 40;  // [s] a frame, and of the film
  return std::max(1 / each, count(sequence) / longest);
}

}  // namespace byhand::course
