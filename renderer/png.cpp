#include "renderer/png.hpp"

#include <fmt/format.h>
#include <libdeflate.h>

#include <cstdlib>
#include <memory>
#include <stdexcept>

#include "renderer/error.hpp"

namespace {

thread_local int level = 1;  // of libdeflate, 1 to 12

// Replaces stb's compressor, which takes ten times as long for slightly larger files.
unsigned char* compress(unsigned char* data, int size, int* compressed_size, int /*quality*/) {
  const std::unique_ptr<libdeflate_compressor, decltype(&libdeflate_free_compressor)> compressor(
      libdeflate_alloc_compressor(level), libdeflate_free_compressor);
  if (!compressor) return nullptr;
  const std::size_t most = libdeflate_zlib_compress_bound(compressor.get(), size);
  auto* out = static_cast<unsigned char*>(std::malloc(most));  // stb frees it
  if (out) *compressed_size = int(libdeflate_zlib_compress(compressor.get(), data, size, out, most));
  return out;
}

}  // namespace

#define STBIW_ZLIB_COMPRESS compress
#define STB_IMAGE_WRITE_STATIC
#define STB_IMAGE_WRITE_IMPLEMENTATION
#define STBI_WRITE_NO_STDIO
#include <stb/stb_image_write.h>

namespace byhand::renderer {
namespace {

// Flat colours compress as well without a filter, and trying all five costs 20 ms per frame.
[[maybe_unused]] const int no_filter = stbi_write_force_png_filter = 0;

}  // namespace

std::string encode_png(const Image& image, Compression compression) {
  const std::size_t expected = 3 * std::size_t(std::max(image.width, 0)) * std::size_t(std::max(image.height, 0));
  if (expected == 0 || image.rgb.size() != expected)
    throw std::invalid_argument(
        fmt::format("An image of {} × {} pixels has {} bytes; it needs {}, and at least one pixel.", image.width,
                    image.height, image.rgb.size(), expected));
  level = compression == Compression::thorough ? 12 : 1;
  std::string bytes;
  const auto append = [](void* to, void* data, int size) {
    static_cast<std::string*>(to)->append(static_cast<const char*>(data), size);
  };
  if (!stbi_write_png_to_func(append, &bytes, image.width, image.height, 3, image.rgb.data(), 3 * image.width))
    throw Unavailable("There is not enough memory to encode a picture.");
  return bytes;
}

}  // namespace byhand::renderer
