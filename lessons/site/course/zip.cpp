#include "lessons/site/course/zip.hpp"

#include <libdeflate.h>

#include <algorithm>
#include <cstdint>
#include <memory>
#include <new>
#include <vector>

#include "lessons/files/atomic_file.hpp"

namespace byhand::site {
namespace {

/// Little-endian, as ZIP wants it.
template <class T>
std::string bytes_of(T number) {
  std::string bytes;
  for (size_t i = 0; i < sizeof(T); ++i) bytes += static_cast<char>(number >> (8 * i) & 0xff);
  return bytes;
}
std::string two(size_t number) { return bytes_of(static_cast<std::uint16_t>(number)); }
std::string four(size_t number) { return bytes_of(static_cast<std::uint32_t>(number)); }

}  // namespace

std::string deflated(std::string_view bytes) {
  constexpr int best = 12;
  const std::unique_ptr<libdeflate_compressor, void (*)(libdeflate_compressor*)> compressor(
      libdeflate_alloc_compressor(best), libdeflate_free_compressor);
  if (!compressor) throw std::bad_alloc();
  std::string out(bytes.size(), '\0');
  out.resize(libdeflate_deflate_compress(compressor.get(), bytes.data(), bytes.size(), out.data(), out.size()));
  return out;
}

void Zip::add(const std::string& name, std::string_view bytes, Store store, bool runs) {
  const std::string packed = store == Store::compressed ? deflated(bytes) : "";
  const bool is_packed = !packed.empty();
  constexpr size_t version = 20, of_unix = 3 << 8, first_of_january_1980 = 33;
  const size_t mode = runs ? 0100755 : 0100644;
  const std::string_view stored = is_packed ? std::string_view(packed) : bytes;
  const std::string about = two(version) + two(0) + two(is_packed ? 8 : 0) + two(0) + two(first_of_january_1980) +
                            four(libdeflate_crc32(0, bytes.data(), bytes.size())) + four(stored.size()) +
                            four(bytes.size()) + two(name.size()) + two(0);
  directory_ += "PK\1\2" + two(of_unix + version) + about + two(0) + two(0) + two(0) + four(mode << 16) +
                four(archive_.size()) + name;
  archive_ += "PK\3\4" + about + name;
  archive_ += stored;
  ++entries_;
}

std::string Zip::finish() {
  const auto entries = static_cast<size_t>(entries_);
  const std::string end = "PK\5\6" + two(0) + two(0) + two(entries) + two(entries) + four(directory_.size()) +
                          four(archive_.size()) + two(0);
  return std::move(archive_) + directory_ + end;
}

std::string zip_of(const std::filesystem::path& folder) {
  std::vector<std::filesystem::path> files;
  for (const auto& entry : std::filesystem::recursive_directory_iterator(folder))
    if (entry.is_regular_file()) files.push_back(entry.path());
  std::sort(files.begin(), files.end());
  Zip zip;
  for (const std::filesystem::path& file : files) {
    using std::filesystem::perms;
    const bool runs = (std::filesystem::status(file).permissions() & perms::owner_exec) != perms::none;
    zip.add(file.lexically_relative(folder).generic_string(), course::read_whole(file).value_or(""),
            Zip::Store::compressed, runs);
  }
  return zip.finish();
}

}  // namespace byhand::site
