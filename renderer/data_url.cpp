#include "renderer/data_url.hpp"

#include <algorithm>
#include <cstdint>

namespace byhand::renderer {

std::string data_url(std::string_view png) {
  constexpr std::string_view digits = "ABCDEFGHIJKLMNOPQRSTUVWXYZabcdefghijklmnopqrstuvwxyz0123456789+/";
  std::string url = "data:image/png;base64,";
  for (std::size_t i = 0; i < png.size(); i += 3) {
    const std::size_t count = std::min<std::size_t>(3, png.size() - i);
    std::uint32_t group = 0;
    for (std::size_t k = 0; k < 3; ++k)
      group = group << 8 | (k < count ? static_cast<unsigned char>(png[i + k]) : 0U);
    for (std::size_t k = 0; k < 4; ++k) url += k > count ? '=' : digits[group >> (18 - 6 * k) & 63];
  }
  return url;
}

}  // namespace byhand::renderer
