#pragma once

namespace byhand::practise {

/// The head of a call; `count` arguments follow. A reply is the number of its values, then the values. The program
/// says `ready` before its first call.
struct Call {
  double function, count;
};

inline constexpr int channel = 3;  // the descriptor of calls and replies
inline constexpr double ready = 0;
// Instead of a number of values:
inline constexpr double not_written = -1;  // the stub is still there
inline constexpr double too_deep = -2;     // the stack is full
inline constexpr double undefined = -3;    // a line and the index of a sentence follow

}  // namespace byhand::practise
