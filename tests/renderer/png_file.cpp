#include "tests/renderer/png_file.hpp"

#include <fstream>
#include <memory>
#include <stdexcept>

#include "renderer/png.hpp"

#define STB_IMAGE_STATIC
#define STB_IMAGE_IMPLEMENTATION
#define STBI_ONLY_PNG
#include <stb/stb_image.h>

namespace byhand::renderer {

Image read_png(const std::filesystem::path& path) {
  Image image;
  int channels = 0;
  const std::unique_ptr<stbi_uc, decltype(&stbi_image_free)> pixels(
      stbi_load(path.c_str(), &image.width, &image.height, &channels, 3), stbi_image_free);
  if (!pixels) throw std::runtime_error("Cannot read " + path.string() + ": " + stbi_failure_reason());
  image.rgb.assign(pixels.get(), pixels.get() + 3 * std::size_t(image.width) * image.height);
  return image;
}

void write_png(const std::filesystem::path& path, const Image& image) {
  std::filesystem::create_directories(path.parent_path());
  std::ofstream out(path, std::ios::binary);
  out << encode_png(image);
  if (!out.flush()) throw std::runtime_error("Cannot write " + path.string());
}

}  // namespace byhand::renderer
