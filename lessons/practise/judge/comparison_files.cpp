#include <fmt/format.h>

#include <string_view>

#include "lessons/files/atomic_file.hpp"
#include "lessons/practise/judge/comparison.hpp"
#include "renderer/frames.hpp"
#include "renderer/opengl/pixel_canvas.hpp"
#include "renderer/png.hpp"

namespace byhand::practise {

std::string still_png(const Film& yours, const Film& right) {
  renderer::PixelCanvas canvas(1280, 720);
  draw_instants(canvas, yours, right, renderer::spread(frames_that_tell(yours, right), 4));
  return renderer::encode_png(canvas.image());
}

void write_film(const std::filesystem::path& folder, const Film& yours, const Film& right) {
  renderer::PixelCanvas canvas(854, 480);
  renderer::FrameEncoder encoder([&](int index, std::string_view png) {
    course::write_whole(folder / fmt::format("{:04}.png", index), png);
  });
  for (int i = 0; i < static_cast<int>(right.frames.size()); ++i) {
    draw(canvas, yours, right, i);
    encoder.add(canvas.image());
  }
  encoder.finish();
}

}  // namespace byhand::practise
