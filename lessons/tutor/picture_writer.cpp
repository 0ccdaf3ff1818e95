#include "lessons/tutor/picture_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <cmath>
#include <filesystem>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/tutor/chart_data.hpp"
#include "lessons/tutor/lesson.hpp"
#include "lessons/tutor/progress.hpp"
#include "lessons/tutor/streams.hpp"
#include "renderer/frames.hpp"
#include "renderer/png.hpp"

namespace byhand::tutor {
namespace {

namespace fs = std::filesystem;
using renderer::Canvas;
using renderer::Image;

constexpr int strip_frames = 6, strip_columns = 3;

Image draw(Canvas& canvas, const Figure& figure) {
  canvas.clear();
  if (const auto* chart = chart_of(figure))
    renderer::draw(canvas, *chart, canvas.page().inset(12));
  else
    std::get<Drawing>(figure.picture)(canvas);
  return canvas.image();
}

Image draw(Canvas& canvas, const FrameDrawing& frame, double time) {
  canvas.clear();
  frame(canvas, time);
  return canvas.image();
}

}  // namespace

std::string figure_path(const std::string& name) { return "figures/" + name + ".png"; }
std::string data_path(const std::string& name) { return "data/" + name + ".csv"; }
std::string frames_folder(const std::string& name) { return "frames/" + name; }
std::string strip_path(const std::string& name) { return "frames/" + name + ".png"; }

PictureWriter::PictureWriter(const Lesson& lesson, const Options& options)
    : output_(options.output / lesson.about().slug),
      quality_(options.quality),
      frames_(options.frames),
      quiet_(options.quiet) {}

Canvas& PictureWriter::canvas() {
  if (!canvas_) canvas_.emplace(quality_.width, quality_.height);
  return *canvas_;
}

Canvas& PictureWriter::small_canvas() {
  if (!small_canvas_) small_canvas_.emplace(640, 360);
  return *small_canvas_;
}

void PictureWriter::write(const Figure& figure) {
  output_.write(figure_path(figure.name), renderer::encode_png(draw(canvas(), figure)));
  if (const auto* chart = chart_of(figure)) output_.write(data_path(figure.name), csv(*chart));
}

void PictureWriter::write(const Sequence& sequence) {
  // Frames of an earlier, longer run must not remain among the new ones.
  output_.remove(frames_folder(sequence.name));
  output_.remove(strip_path(sequence.name));
  if (frames_ == FramesWanted::none) return;

  const int frames = count(sequence);
  const std::vector<int> in_strip = renderer::spread(frames, strip_frames);
  const bool all = frames_ == FramesWanted::all;
  Progress progress(fmt::format("drawing {}", sequence.name), all ? frames : static_cast<int>(in_strip.size()),
                    quiet_);
  renderer::FrameWriter writer(
      frames_folder(sequence.name), renderer::FrameWriter::Encoding::beside,
      [this](const fs::path& path, std::string_view bytes) { output_.write(path.string(), bytes); });
  std::vector<Image> strip;
  FrameDrawing drawing = sequence.draw;
  for (int i = 0; i < frames; ++i) {
    const bool shown = std::binary_search(in_strip.begin(), in_strip.end(), i);
    if (!all && !shown) continue;
    Image image = draw(canvas(), drawing, time(sequence, i));
    if (shown) strip.push_back(image);
    if (all)
      writer.write(std::move(image));
    else if (i == frames - 1)
      output_.write(writer.path(i).string(), renderer::encode_png(image));
    progress.advance();
  }
  writer.finish();
  output_.write(strip_path(sequence.name), renderer::encode_png(renderer::strip(strip, strip_columns)));
}

Image PictureWriter::small(const Figure& figure) { return draw(small_canvas(), figure); }
Image PictureWriter::small(const FrameDrawing& frame, double at) { return draw(small_canvas(), frame, at); }

int PictureWriter::count(const Sequence& sequence) const {
  if (const auto* frames = std::get_if<Frames>(&sequence.length)) return std::max(1, frames->value);
  return static_cast<int>(std::lround(std::get<Seconds>(sequence.length).value * quality_.rate)) + 1;
}

double PictureWriter::time(const Sequence& sequence, int index) const {
  if (std::holds_alternative<Frames>(sequence.length)) return index;
  return static_cast<double>(index) / quality_.rate;
}

std::string PictureWriter::path(const Figure& figure) const {
  return printable((output_.path() / figure_path(figure.name)).string());
}

std::string PictureWriter::path(const Sequence& sequence) const {
  return frames_ == FramesWanted::none ? "" : printable((output_.path() / strip_path(sequence.name)).string());
}

std::string PictureWriter::gl() const { return canvas_ ? canvas_->describe() : ""; }

}  // namespace byhand::tutor
