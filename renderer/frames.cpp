#include "renderer/frames.hpp"

#include <fmt/format.h>

#include <algorithm>
#include <stdexcept>

#include "renderer/palette.hpp"
#include "renderer/png.hpp"
#include "renderer/threads.hpp"

#define STB_IMAGE_RESIZE_STATIC
#define STB_IMAGE_RESIZE_IMPLEMENTATION
#include <stb/stb_image_resize.h>

namespace byhand::renderer {

namespace {
constexpr std::size_t capacity = 4;  // frames in the queue: 11 MB at 1280 × 720
}

FrameEncoder::FrameEncoder(Sink sink)
    : sink_(std::move(sink)), thread_(started_thread([this] { encode_queue(); })) {}

FrameEncoder::~FrameEncoder() {
  {
    const std::lock_guard lock(mutex_);
    queue_.clear();
  }
  stop();
}

void FrameEncoder::add(Image image) {
  if (!thread_.joinable()) return sink_(count_++, encode_png(image));
  std::unique_lock lock(mutex_);
  changed_.wait(lock, [this] { return queue_.size() < capacity || error_; });
  if (error_) std::rethrow_exception(error_);
  queue_.push_back(std::move(image));
  changed_.notify_all();
}

void FrameEncoder::finish() {
  stop();
  if (error_) std::rethrow_exception(error_);
}

void FrameEncoder::stop() {
  {
    const std::lock_guard lock(mutex_);
    closed_ = true;
  }
  changed_.notify_all();
  if (thread_.joinable()) thread_.join();
}

void FrameEncoder::encode_queue() {
  std::unique_lock lock(mutex_);
  for (int index = 0;; ++index) {
    changed_.wait(lock, [this] { return !queue_.empty() || closed_; });
    if (queue_.empty()) return;
    const Image image = std::move(queue_.front());
    queue_.pop_front();
    lock.unlock();
    changed_.notify_all();
    try {
      sink_(index, encode_png(image));
      lock.lock();
    } catch (...) {
      lock.lock();
      error_ = std::current_exception();
      queue_.clear();
      changed_.notify_all();
      return;
    }
  }
}

Image strip(std::span<const Image> images, int columns, int width, int gap) {
  if (images.empty() || columns < 1 || gap < 0 || width < columns * (gap + 1) + gap)
    throw std::invalid_argument(
        fmt::format("A strip needs at least one image, one column and one pixel for each; got {} images in "
                    "{} columns on {} pixels.",
                    images.size(), columns, width));
  const Image& first = images.front();
  for (const Image& image : images)
    if (image.width != first.width || image.height != first.height)
      throw std::invalid_argument(fmt::format("The images of a strip have one size; got {} × {} and {} × {}.",
                                              first.width, first.height, image.width, image.height));
  const int rows = (int(images.size()) + columns - 1) / columns;
  const int w = (width - gap * (columns + 1)) / columns;
  const int h = std::max(1, int(std::int64_t(w) * first.height / first.width));
  Image sheet{width, rows * (h + gap) + gap, {}};
  const std::uint8_t paper[] = {palette::paper.r, palette::paper.g, palette::paper.b};
  sheet.rgb.resize(3 * std::size_t(sheet.width) * sheet.height);
  for (std::size_t i = 0; i < sheet.rgb.size(); ++i) sheet.rgb[i] = paper[i % 3];
  for (std::size_t i = 0; i < images.size(); ++i) {
    const int x = gap + int(i) % columns * (w + gap), y = gap + int(i) / columns * (h + gap);
    std::uint8_t* corner = sheet.rgb.data() + 3 * (std::size_t(y) * sheet.width + x);
    stbir_resize_uint8_srgb(images[i].rgb.data(), first.width, first.height, 0, corner, w, h, 3 * sheet.width, 3,
                            STBIR_ALPHA_CHANNEL_NONE, 0);
  }
  return sheet;
}

std::vector<int> spread(int count, int n) {
  const int shown = std::min(count, n);
  if (shown == 1) return {count - 1};
  std::vector<int> indices;
  indices.reserve(std::size_t(std::max(shown, 0)));
  for (int i = 0; i < shown; ++i) indices.push_back(int(std::int64_t(i) * (count - 1) / (shown - 1)));
  return indices;
}

}  // namespace byhand::renderer
