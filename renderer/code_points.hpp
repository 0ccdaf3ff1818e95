#pragma once

#include <cstddef>
#include <string_view>

namespace byhand::renderer {

/// Takes the next code point of UTF-8 from the front of `text`, which is not empty; an invalid byte is returned as
/// it is.
inline char32_t next_code_point(std::string_view& text) {
  const auto byte = [&](std::size_t i) { return static_cast<unsigned char>(text[i]); };
  const unsigned char head = byte(0);
  const std::size_t length = head >= 0xf0 ? 4 : head >= 0xe0 ? 3 : head >= 0xc0 ? 2 : 1;
  char32_t code = head;
  if (length > 1 && length <= text.size()) {
    code = head & (0x7f >> length);
    for (std::size_t i = 1; i < length; ++i) code = code << 6 | (byte(i) & 0x3f);
    text.remove_prefix(length);
  } else {
    text.remove_prefix(1);
  }
  return code;
}

}  // namespace byhand::renderer
