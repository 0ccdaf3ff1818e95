#pragma once

#include <fmt/format.h>

#include <cstddef>
#include <iterator>
#include <string>

#include "lessons/practise/judge/undefined.hpp"

namespace byhand::practise {

/// A learner's program ended, or answered nothing that counts.
struct Stopped {
  std::string sentence;
  bool not_written = false;  // the stub said so
};

/// " in line 5", or nothing where the line is not known.
inline std::string in_line(double line) { return line > 0 ? fmt::format(" in line {:.0f}", line) : ""; }

/// Whether a program may have said this of what it did.
inline bool is_undefined(double kind, double line) {
  return kind >= 0 && kind < static_cast<double>(std::size(undefined_words)) && line >= 0 && line < 1e6;
}
inline std::string undefined_sentence(double kind, double line) {
  return fmt::format("Your code {}{}.", undefined_words[static_cast<std::size_t>(kind)], in_line(line));
}

}  // namespace byhand::practise
