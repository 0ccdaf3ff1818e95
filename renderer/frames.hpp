#pragma once

#include <condition_variable>
#include <cstddef>
#include <deque>
#include <exception>
#include <filesystem>
#include <functional>
#include <mutex>
#include <span>
#include <string_view>
#include <thread>

#include "renderer/file.hpp"
#include "renderer/image.hpp"

namespace byhand::renderer {

/// Writes an image sequence `<folder>/0000.png`, `0001.png`, …, and encodes it on a background thread.
class FrameWriter {
 public:
  enum class Encoding { beside, at_once };
  /// Writes the bytes of a frame's file; called on the background thread.
  using WriteFile = std::function<void(const std::filesystem::path& path, std::string_view bytes)>;

  /// `Encoding::at_once` starts no thread: `write` returns once the file exists.
  explicit FrameWriter(std::filesystem::path folder, Encoding encoding = Encoding::beside,
                       WriteFile write_file = write_whole);
  FrameWriter(const FrameWriter&) = delete;
  FrameWriter& operator=(const FrameWriter&) = delete;
  /// Waits for the file being written and drops the queue. Call `finish` first to write all frames.
  ~FrameWriter();

  /// Queues the next frame; waits while four are queued. Rethrows the error of an earlier frame (EnvironmentError
  /// for a full disk, …), after which no frame is written.
  void write(Image image);

  /// Waits until every frame is written and rethrows an error. No frame may follow.
  void finish();

  /// Number of frames so far.
  int count() const { return count_; }
  /// Path of frame `index`.
  std::filesystem::path path(int index) const;

 private:
  void encode_queue();
  void stop();

  std::filesystem::path folder_;
  Encoding encoding_;
  WriteFile write_file_;
  int count_ = 0;
  int written_ = 0;
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
