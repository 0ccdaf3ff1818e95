#include "lessons/files/picture_writer.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <string_view>
#include <utility>
#include <vector>

#include "lessons/files/chart_data.hpp"
#include "lessons/files/streams.hpp"
#include "lessons/files/video.hpp"
#include "lessons/page/lesson.hpp"
#include "lessons/page/progress.hpp"
#include "renderer/frames.hpp"
#include "renderer/png.hpp"

namespace byhand::course {
namespace {

using renderer::Image;

/// Two frames that tell the most: after two fifths, when something has happened, and the last.
std::vector<int> key_frames(int count) {
  const int first = 2 * (count - 1) / 5, last = count - 1;
  return first == last ? std::vector<int>{last} : std::vector<int>{first, last};
}

}  // namespace

std::string figure_path(const std::string& name) { return "figures/" + name + ".png"; }
std::string data_path(const std::string& name) { return "data/" + name + ".csv"; }
std::string frames_folder(const std::string& name) { return "frames/" + name; }
std::string strip_path(const std::string& name) { return "frames/" + name + ".png"; }
std::string film_path(const std::string& name, const std::string& format) {
  return "frames/" + name + "." + format;
}

PictureWriter::PictureWriter(const Lesson& lesson, const Options& options)
    : output_(options.output / lesson.about().slug),
      drawer_(options.quality),
      frames_(options.frames),
      film_(options.film),
      quiet_(options.quiet) {}

void PictureWriter::write(const Figure& figure) {
  output_.write(figure_path(figure.name), renderer::encode_png(drawer_.draw(figure)));
  if (!figure.data.empty())
    output_.write(data_path(figure.name), figure.data);
  else if (const auto* chart = chart_of(figure))
    output_.write(data_path(figure.name), csv(*chart));
}

void PictureWriter::write(const Sequence& sequence) {
  // Frames of an earlier, longer run must not remain among the new ones.
  output_.remove(frames_folder(sequence.name));
  output_.remove(strip_path(sequence.name));
  for (const char* format : {"webm", "mp4"}) output_.remove(film_path(sequence.name, format));
  if (frames_ == FramesWanted::none) return;

  const int frames = drawer_.count(sequence);
  const std::vector<int> in_strip = key_frames(frames);
  const bool all = frames_ == FramesWanted::all;
  Progress progress(fmt::format("drawing {}", sequence.name), all ? frames : static_cast<int>(in_strip.size()),
                    quiet_);
  const auto write_frame = [&](int index, std::string_view png) {
    output_.write(fmt::format("{}/{:04}.png", frames_folder(sequence.name), index), png);
  };
  renderer::FrameEncoder encoder(write_frame);
  std::vector<Image> strip;
  FrameDrawing drawing = sequence.draw;
  for (int i = 0; i < frames; ++i) {
    const bool shown = std::binary_search(in_strip.begin(), in_strip.end(), i);
    if (!all && !shown) continue;
    Image image = drawer_.draw(drawing, drawer_.time(sequence, i));
    if (shown) strip.push_back(image);
    if (all)
      encoder.add(std::move(image));
    else if (i == frames - 1)
      write_frame(i, renderer::encode_png(image));
    progress.advance();
  }
  encoder.finish();
  constexpr int gap = 12;
  output_.write(strip_path(sequence.name),
                renderer::encode_png(renderer::strip(strip, 1, strip.front().width + 2 * gap, gap)));
  if (!film_.empty())
    output_.write(film_path(sequence.name, film_),
                  encoded_film(output_.path() / frames_folder(sequence.name), drawer_.rate(sequence), film_));
}

std::string PictureWriter::path(const Figure& figure) const {
  return printable((output_.path() / figure_path(figure.name)).string());
}

std::string PictureWriter::path(const Sequence& sequence) const {
  return frames_ == FramesWanted::none ? "" : printable((output_.path() / strip_path(sequence.name)).string());
}

}  // namespace byhand::course
