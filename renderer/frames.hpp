#pragma once

#include <condition_variable>
#include <deque>
#include <exception>
#include <functional>
#include <mutex>
#include <span>
#include <string_view>
#include <thread>
#include <vector>

#include "renderer/image.hpp"

namespace byhand::renderer {

/// Encodes the images of a sequence as PNG files, on a background thread, or at once where none can be started.
class FrameEncoder {
 public:
  /// Receives the bytes of frame 0, 1, …, in this order, on that thread.
  using Sink = std::function<void(int index, std::string_view png)>;

  explicit FrameEncoder(Sink sink);
  FrameEncoder(const FrameEncoder&) = delete;
  FrameEncoder& operator=(const FrameEncoder&) = delete;
  /// Waits for the frame being encoded and drops the queue. Call `finish` first to encode all frames.
  ~FrameEncoder();

  /// Queues the next frame; waits while four are queued. Rethrows the error of an earlier frame (that of the sink,
  /// for one), after which no frame is encoded.
  void add(Image image);

  /// Waits until every frame has reached the sink and rethrows an error. No frame may follow.
  void finish();

 private:
  void encode_queue();
  void stop();

  Sink sink_;
  int count_ = 0;  // of frames that were encoded at once
  std::deque<Image> queue_;
  bool closed_ = false;
  std::exception_ptr error_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
};

/// A contact sheet: the images in `columns` columns, row by row, scaled so that the sheet is `width` pixels wide,
/// with gaps of `gap` pixels. Throws std::invalid_argument unless all images have the same size.
Image strip(std::span<const Image> images, int columns, int width = 1920, int gap = 12);

/// At most `n` indices, evenly spaced over 0 … count−1 and including both ends (for n = 1 the last): the frames of
/// a contact sheet.
std::vector<int> spread(int count, int n);

}  // namespace byhand::renderer
