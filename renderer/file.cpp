#include "renderer/file.hpp"

#include <fmt/format.h>

#include <cerrno>
#include <cstdio>
#include <system_error>

#include "renderer/error.hpp"

namespace byhand::renderer {
namespace fs = std::filesystem;
namespace {

[[noreturn]] void refuse(const fs::path& path, const std::error_code& reason) {
  throw EnvironmentError(fmt::format("Cannot write {}: {}.", path.string(), reason.message()));
}

std::error_code last_error() { return {errno, std::generic_category()}; }

}  // namespace

void write_whole(const fs::path& path, std::string_view bytes) {
  std::error_code error;
  if (path.has_parent_path()) fs::create_directories(path.parent_path(), error);
  if (error) refuse(path, error);

  const fs::path part = path.string() + ".part";
  std::FILE* file = std::fopen(part.c_str(), "wb");
  if (!file) refuse(path, last_error());
  if (std::fwrite(bytes.data(), 1, bytes.size(), file) != bytes.size()) error = last_error();
  // A full disk may be reported only when the last buffer is flushed.
  if (std::fclose(file) != 0 && !error) error = last_error();
  if (!error) fs::rename(part, path, error);
  if (error) {
    std::error_code ignored;
    fs::remove(part, ignored);
    refuse(path, error);
  }
}

}  // namespace byhand::renderer
