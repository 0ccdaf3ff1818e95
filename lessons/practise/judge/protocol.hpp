#pragma once

namespace byhand::practise {

/// The head of a call; `count` arguments follow. A reply is the number of its values, then the values.
struct Call {
  double function, count;
};

inline constexpr int replies = 3;  // descriptor
inline constexpr double not_written = -1;

}  // namespace byhand::practise
