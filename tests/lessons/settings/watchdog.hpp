#pragma once

#include <signal.h>
#include <unistd.h>

#include <cstring>
#include <string>

namespace byhand::tests {

/// While it lives, a crash, or five minutes without an end, leave the command that led there on standard error.
class Watchdog {
 public:
  explicit Watchdog(const std::string& command) {
    command_ = command + "\n";
    for (const int number : {SIGSEGV, SIGFPE, SIGABRT, SIGALRM}) signal(number, tell);
    alarm(300);
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog() {
    alarm(0);
    for (const int number : {SIGSEGV, SIGFPE, SIGABRT, SIGALRM}) signal(number, SIG_DFL);
  }

 private:
  static void tell(int number) {
    const auto write_out = [](const char* words, std::size_t size) { (void)!write(STDERR_FILENO, words, size); };
    const char* what = number == SIGALRM ? "takes more than five minutes: " : "crashes: ";
    write_out(what, std::strlen(what));
    write_out(command_.data(), command_.size());
    _exit(1);
  }

  static inline std::string command_;
};

}  // namespace byhand::tests
