#include "renderer/data_url.hpp"

#include <algorithm>
#include <cstdint>

namespace byhand::renderer {

std::string base64(std::string_view bytes) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string letters;
  for (std::size_t i = 0; i < bytes.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, bytes.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(bytes[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) letters += k > count ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return letters;
}

std::string data_url(std::string_view png) { return "data:image/png;base64," + base64(png); }

}  // namespace byhand::renderer
