#include "renderer/file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "renderer/error.hpp"

namespace byhand::renderer {
namespace fs = std::filesystem;
namespace {

constexpr std::string_view prefix = ".byhand-", suffix = ".part";

void require(bool done) {
  if (!done) throw std::system_error(errno, std::generic_category());
}

/// The name of a temporary file while it exists, where a signal handler finds it: static memory, never freed.
struct Unfinished {
  std::atomic<bool> claimed{false}, named{false};
  std::array<char, PATH_MAX> name{};
};
std::array<Unfinished, 16> unfinished;  // more than there are threads that write

class Listed {
 public:
  explicit Listed(const std::string& name) {
    for (Unfinished& place : unfinished) {
      if (name.size() >= place.name.size() || place.claimed.exchange(true)) continue;
      place.name[name.copy(place.name.data(), name.size())] = '\0';
      place.named = true;
      place_ = &place;
      return;
    }
  }
  Listed(const Listed&) = delete;
  Listed& operator=(const Listed&) = delete;
  ~Listed() {
    if (!place_) return;
    place_->named = false;
    place_->claimed = false;
  }

 private:
  Unfinished* place_ = nullptr;
};

class Descriptor {
 public:
  Descriptor(const fs::path& path, int flags) : number_(::open(path.c_str(), flags | O_CLOEXEC, 0666)) {}
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }
  explicit operator bool() const { return number_ >= 0; }

  void write(std::string_view bytes) const {
    while (!bytes.empty()) {
      const ssize_t written = ::write(number_, bytes.data(), bytes.size());
      if (written < 0 && errno == EINTR) continue;
      require(written >= 0);
      bytes.remove_prefix(static_cast<std::size_t>(written));
    }
  }
  void sync() const { require(::fsync(number_) == 0); }
  /// A full disk of a server may be reported only here.
  void close() { require(::close(std::exchange(number_, -1)) == 0); }

 private:
  int number_;
};

void sync_folder(const fs::path& folder) {
  const Descriptor descriptor(folder.empty() ? "." : folder, O_RDONLY | O_DIRECTORY);
  require(bool(descriptor));
  try {
    descriptor.sync();
  } catch (const std::system_error& error) {
    if (error.code() != std::errc::invalid_argument) throw;  // file systems that sync no folders
  }
}

void make_folder(const fs::path& folder) {
  if (folder.empty() || fs::is_directory(folder)) return;
  make_folder(folder.parent_path());
  if (::mkdir(folder.c_str(), 0777) == 0) return sync_folder(folder.parent_path());
  const int reason = errno == EEXIST ? ENOTDIR : errno;
  // Another process may have made it meanwhile.
  if (!fs::is_directory(folder)) throw std::system_error(reason, std::generic_category());
}

fs::path temporary_beside(const fs::path& path) {
  static std::atomic<int> next{0};
  return path.parent_path() / fmt::format("{}{}-{}{}", prefix, getpid(), next++, suffix);
}

void write_and_rename(const fs::path& temporary, const fs::path& path, std::string_view bytes) {
  Descriptor file(temporary, O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW);
  require(bool(file));
  try {
    file.write(bytes);
    file.sync();
    file.close();
    fs::rename(temporary, path);
  } catch (...) {
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(path.parent_path());
}

}  // namespace

void write_whole(const fs::path& path, std::string_view bytes) {
  try {
    make_folder(path.parent_path());
    // A process of the same number, in another container or before a power failure, may have left such a name.
    for (int attempt = 0;; ++attempt) {
      const fs::path temporary = temporary_beside(path);
      const Listed listed(temporary.string());
      try {
        return write_and_rename(temporary, path, bytes);
      } catch (const std::system_error& error) {
        if (error.code() != std::errc::file_exists || attempt == 100) throw;
      }
    }
  } catch (const std::system_error& error) {
    throw EnvironmentError(fmt::format("Cannot write {}: {}.", path.string(), error.code().message()));
  }
}

std::optional<std::string> read_whole(const fs::path& path) {
  std::error_code error;
  if (!fs::is_regular_file(path, error)) return std::nullopt;
  std::ifstream file(path, std::ios::binary);
  std::string bytes{std::istreambuf_iterator<char>(file), {}};
  return file ? std::optional(std::move(bytes)) : std::nullopt;
}

bool is_unfinished(const fs::path& path) {
  const std::string name = path.filename().string();
  return name.starts_with(prefix) && name.ends_with(suffix);
}

void remove_unfinished() noexcept {
  for (const Unfinished& place : unfinished)
    if (place.named) ::unlink(place.name.data());
}

}  // namespace byhand::renderer
