#include "renderer/font_file.hpp"

#include <fmt/format.h>

#include <fstream>
#include <iterator>

#include "renderer/error.hpp"

namespace byhand::renderer {
namespace {

/// Whether the font's tables lie within the file: stb_truetype reads them without asking.
bool is_whole(const std::vector<unsigned char>& file) {
  const auto number = [&](std::size_t at, int bytes) {
    std::size_t value = 0;
    for (int i = 0; i < bytes; ++i) value = value << 8 | file[at + std::size_t(i)];
    return value;
  };
  constexpr std::size_t header = 12, record = 16;
  if (file.size() < header || file.size() < header + record * number(4, 2)) return false;
  for (std::size_t at = header; at < header + record * number(4, 2); at += record)
    if (number(at + 8, 4) + number(at + 12, 4) > file.size()) return false;
  return true;
}

}  // namespace

std::vector<unsigned char> font_file(const char* name) {
  const std::string path = fmt::format(BYHAND_FONTS "/{}", name);
  std::ifstream in(path, std::ios::binary);
  std::vector<unsigned char> bytes(std::istreambuf_iterator<char>(in), {});
  if (!is_whole(bytes))
    throw Unavailable(fmt::format(
        "There is no whole font at {}: apt install --reinstall fonts-dejavu-core fonts-dejavu-extra.", path));
  return bytes;
}

}  // namespace byhand::renderer
