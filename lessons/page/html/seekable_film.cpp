#include "lessons/page/html/seekable_film.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>

namespace byhand::site {

using namespace course;

bool SeekableFilm::in_real_time() const { return std::holds_alternative<Seconds>(sequence_->length); }

int SeekableFilm::frames() const {
  if (const auto* frames = std::get_if<Frames>(&sequence_->length)) return std::max(1, frames->value);
  return static_cast<int>(std::lround(std::get<Seconds>(sequence_->length).value * rate)) + 1;
}

void SeekableFilm::draw(renderer::Canvas& canvas, int index) {
  index = std::clamp(index, 0, frames() - 1);
  if (index < last_) drawing_ = sequence_->draw;
  last_ = index;
  drawing_(canvas, in_real_time() ? static_cast<double>(index) / rate : index);
}

std::string SeekableFilm::screen(const std::string& svg) const {
  return fmt::format("<div class=\"screen\" data-frames=\"{}\" data-rate=\"{}\">{}</div>", frames(),
                     in_real_time() ? rate : 0, svg);
}

}  // namespace byhand::site
