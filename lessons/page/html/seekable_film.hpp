#pragma once

#include <string>

#include "lessons/page/items.hpp"

namespace byhand::site {

/// A sequence whose frames can be asked for in any order. One that lies before the last is drawn from the
/// beginning, because a drawing advances its simulation to the time that it draws.
class SeekableFilm {
 public:
  static constexpr int rate = 30;  // frames per second of a sequence in real time

  explicit SeekableFilm(const course::Sequence& sequence) : sequence_(&sequence), drawing_(sequence.draw) {}

  int frames() const;
  bool in_real_time() const;
  void draw(renderer::Canvas& canvas, int index);
  /// One of its frames as a page has it, with how many there are and how many a second.
  std::string screen(const std::string& svg) const;

 private:
  const course::Sequence* sequence_;
  course::FrameDrawing drawing_;
  int last_ = 0;
};

}  // namespace byhand::site
