// Preloaded into a program, lets one of its system calls fail:
//   FAIL_CALL=write FAIL_AT=3 FAIL_BELOW=/tmp/output  the third write to a file below that folder
//   FAILED=/tmp/failed                                this file is made when it has failed
//   SLOW_FSYNC=1                                      each fsync takes a fifth of a second
//   THREADS=2                                         no more than two threads are ever started

#include <dlfcn.h>
#include <fcntl.h>
#include <pthread.h>
#include <sys/stat.h>
#include <sys/syscall.h>
#include <unistd.h>

#include <array>
#include <atomic>
#include <cerrno>
#include <climits>
#include <cstdarg>
#include <cstdlib>
#include <string_view>

namespace {

std::string_view variable(const char* name) {
  const char* const value = std::getenv(name);
  return value ? value : "";
}

bool fails(std::string_view call, std::string_view path) {
  static std::atomic<int> count{0};
  const std::string_view below = variable("FAIL_BELOW");
  if (call != variable("FAIL_CALL") || !path.starts_with(below)) return false;
  if (++count != std::atoi(variable("FAIL_AT").data())) return false;
  const auto file = syscall(SYS_openat, AT_FDCWD, variable("FAILED").data(), O_CREAT | O_WRONLY, 0600);
  syscall(SYS_close, file);
  errno = call == "write" ? ENOSPC : EIO;
  return true;
}

bool fails(std::string_view call, int descriptor) {
  if (call != variable("FAIL_CALL")) return false;
  std::array<char, 64> link{"/proc/self/fd/"};
  int end = 14;
  for (int unit = 1000000; unit > 0; unit /= 10)
    if (descriptor >= unit || unit == 1)
      link[static_cast<std::size_t>(end++)] = static_cast<char>('0' + descriptor / unit % 10);
  std::array<char, PATH_MAX> path{};
  const ssize_t length = readlink(link.data(), path.data(), path.size());
  return length > 0 && fails(call, std::string_view(path.data(), static_cast<std::size_t>(length)));
}

template <class Function>
Function* real(const char* name) {
  return reinterpret_cast<Function*>(dlsym(RTLD_NEXT, name));
}

}  // namespace

extern "C" {

int open(const char* path, int flags, ...) {
  va_list rest;
  va_start(rest, flags);
  const int mode = (flags & O_CREAT) != 0 ? va_arg(rest, int) : 0;
  va_end(rest);
  return fails("open", path) ? -1 : real<int(const char*, int, ...)>("open")(path, flags, mode);
}
ssize_t write(int descriptor, const void* bytes, size_t count) {
  return fails("write", descriptor) ? -1
                                    : real<ssize_t(int, const void*, size_t)>("write")(descriptor, bytes, count);
}
int fsync(int descriptor) {
  if (!variable("SLOW_FSYNC").empty()) usleep(200'000);
  return fails("fsync", descriptor) ? -1 : real<int(int)>("fsync")(descriptor);
}
int close(int descriptor) {
  const bool failed = fails("close", descriptor);
  const int closed = real<int(int)>("close")(descriptor);
  if (failed) errno = EIO;
  return failed ? -1 : closed;
}
int rename(const char* from, const char* to) noexcept {
  return fails("rename", to) ? -1 : real<int(const char*, const char*)>("rename")(from, to);
}
int mkdir(const char* path, mode_t mode) noexcept {
  return fails("mkdir", path) ? -1 : real<int(const char*, mode_t)>("mkdir")(path, mode);
}
int pthread_create(pthread_t* thread, const pthread_attr_t* attributes, void* (*begin)(void*),
                   void* with) noexcept {
  static std::atomic<int> started{0};
  const std::string_view most = variable("THREADS");
  if (!most.empty() && ++started > std::atoi(most.data())) return EAGAIN;
  return real<int(pthread_t*, const pthread_attr_t*, void* (*)(void*), void*)>("pthread_create")(
      thread, attributes, begin, with);
}
int remove(const char* path) noexcept {
  return fails("remove", path) ? -1 : real<int(const char*)>("remove")(path);
}

}  // extern "C"
