#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <mutex>
#include <span>
#include <thread>

#include "renderer/image.hpp"

namespace byhand::renderer {

/// Writes an image sequence `<folder>/0000.png`, `0001.png`, …, encoding on a thread of its own beside the
/// drawing.
class FrameWriter {
 public:
  enum class Encoding { beside, at_once };

  /// `Encoding::at_once` starts no thread: each `write` returns when its file is there.
  explicit FrameWriter(std::filesystem::path folder, Encoding encoding = Encoding::beside);
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  /// Waits for the file being written and drops what is still queued: call `finish` when every frame matters.
  ~FrameWriter();

  /// Hands over the next frame; waits while four are queued. Throws what went wrong with an earlier one
  /// (EnvironmentError for a full disk, …); after that no further frame is written.
  void write(Image image);

  /// Waits until every frame is written and throws what went wrong with any of them. No frame may follow.
  void finish();

  /// Frames handed over so far.
  int count() const { return count_; }
  /// The path that frame `index` has.
  std::filesystem::path path(int index) const;

 private:
  void encode_queue();
  void stop();

  std::filesystem::path folder_;
  Encoding encoding_;
  int count_ = 0;
  int written_ = 0;
  std::deque<Image> queue_;
  bool closed_ = false;
  std::exception_ptr error_;
  std::mutex mutex_;
  std::condition_variable changed_;
  std::thread thread_;
};

/// The images in a grid of `columns`, row by row, each shrunk so that the whole is `width` pixels wide, with
/// `gap` pixels of paper between and around them. All images have one size; throws std::invalid_argument
/// otherwise.
Image strip(std::span<const Image> images, int columns, int width = 1920, int gap = 12);

/// At most `n` indices spread evenly over 0 … count−1, first and last among them (for n = 1 the last): the frames
/// that a strip shows.
std::vector<int> spread(int count, int n);

}  // namespace byhand::renderer
