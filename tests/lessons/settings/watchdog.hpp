#pragma once

#include <signal.h>
#include <sys/time.h>
#include <unistd.h>

#include <cstring>
#include <string>

namespace byhand::tests {

/// While it lives, a crash, or five minutes of computing without an end, leave the command that led there on
/// standard error.
class Watchdog {
 public:
  explicit Watchdog(const std::string& command) {
    command_ = command + "\n";
    for (const int number : {SIGSEGV, SIGFPE, SIGABRT, SIGPROF}) signal(number, tell);
    limit(300);
  }
  Watchdog(const Watchdog&) = delete;
  Watchdog& operator=(const Watchdog&) = delete;
  ~Watchdog() {
    limit(0);
    for (const int number : {SIGSEGV, SIGFPE, SIGABRT, SIGPROF}) signal(number, SIG_DFL);
  }

 private:
  static void limit(int seconds) {
    const itimerval timer{{}, {seconds, 0}};
    setitimer(ITIMER_PROF, &timer, nullptr);
  }

  static void tell(int number) {
    const auto write_out = [](const char* words, std::size_t size) { (void)!write(STDERR_FILENO, words, size); };
    const char* what = number == SIGPROF ? "computes for more than five minutes: " : "crashes: ";
    write_out(what, std::strlen(what));
    write_out(command_.data(), command_.size());
    _exit(1);
  }

  static inline std::string command_;
};

}  // namespace byhand::tests
