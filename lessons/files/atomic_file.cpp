#include "lessons/files/atomic_file.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <sched.h>
#include <sys/stat.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <csignal>
#include <fstream>
#include <iterator>
#include <string>
#include <system_error>
#include <utility>

#include "lessons/page/error.hpp"

namespace byhand::course {
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

/// Held while a temporary file is created, and for good by a process that ends: so none is created behind the back
/// of the handler that removes them.
std::atomic_flag creating = ATOMIC_FLAG_INIT;
std::atomic<bool> ending{false};

void wait_for_turn() {
  while (creating.test_and_set()) sched_yield();
}

[[noreturn]] void wait_for_the_end() {
  for (;;) pause();
}

/// Opens a new file, which is no symbolic link. A handler must not run in a thread that holds `creating`.
int create(const fs::path& path) {
  sigset_t all, before;
  sigfillset(&all);
  pthread_sigmask(SIG_BLOCK, &all, &before);
  wait_for_turn();
  const int number = ::open(path.c_str(), O_WRONLY | O_CREAT | O_EXCL | O_NOFOLLOW | O_CLOEXEC, 0666);
  creating.clear();
  const int error = errno;
  pthread_sigmask(SIG_SETMASK, &before, nullptr);
  errno = error;
  return number;
}

class Descriptor {
 public:
  explicit Descriptor(int number) : number_(number) { require(number >= 0); }
  Descriptor(const Descriptor&) = delete;
  Descriptor& operator=(const Descriptor&) = delete;
  ~Descriptor() {
    if (number_ >= 0) ::close(number_);
  }

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
  const Descriptor descriptor(::open(folder.empty() ? "." : folder.c_str(), O_RDONLY | O_DIRECTORY | O_CLOEXEC));
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

/// A rename would put a file in the place of a device or a pipe, for every program of the machine if we are root.
void require_replaceable(const fs::path& path) {
  std::error_code error;
  const fs::file_status there = fs::symlink_status(path, error);
  if (fs::exists(there) && !fs::is_regular_file(there) && !fs::is_symlink(there))
    throw EnvironmentError(
        fmt::format("Cannot write {}: it is no file but a folder, a device or a pipe.", path.string()));
}

void write_and_rename(const fs::path& temporary, const fs::path& path, std::string_view bytes) {
  Descriptor file(create(temporary));
  try {
    file.write(bytes);
    file.sync();
    file.close();
    fs::rename(temporary, path);
  } catch (...) {
    if (ending) wait_for_the_end();  // the file is gone already, and the process soon
    ::unlink(temporary.c_str());
    throw;
  }
  sync_folder(path.parent_path());
}

}  // namespace

void write_whole(const fs::path& path, std::string_view bytes) {
  try {
    make_folder(path.parent_path());
    require_replaceable(path);
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
  if (ending.exchange(true)) return;
  wait_for_turn();
  for (const Unfinished& place : unfinished)
    if (place.named) ::unlink(place.name.data());
}

}  // namespace byhand::course
