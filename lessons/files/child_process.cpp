#include "lessons/files/child_process.hpp"

#include <sys/prctl.h>
#include <sys/wait.h>
#include <termios.h>
#include <unistd.h>

#include <cerrno>
#include <csignal>
#include <cstdio>
#include <system_error>

#include "lessons/files/streams.hpp"

namespace byhand::course {
namespace {

sigset_t signals(const std::vector<int>& numbers) {
  sigset_t set;
  sigemptyset(&set);
  for (const int number : numbers) sigaddset(&set, number);
  return set;
}

/// Blocks signals while it exists, so that sigwaitinfo() can wait for them.
class Blocked {
 public:
  explicit Blocked(const sigset_t& set) { sigprocmask(SIG_BLOCK, &set, &before_); }
  Blocked(const Blocked&) = delete;
  Blocked& operator=(const Blocked&) = delete;
  ~Blocked() { sigprocmask(SIG_SETMASK, &before_, nullptr); }
  const sigset_t& before() const { return before_; }

 private:
  sigset_t before_{};
};

/// The settings of the terminal when it was made. A program that reads key by key may be killed before it has put
/// them back.
class TerminalAsItIs {
 public:
  TerminalAsItIs() : known_(tcgetattr(STDIN_FILENO, &settings_) == 0) {}
  void put_back() const {
    const bool ours = tcgetpgrp(STDIN_FILENO) == getpgrp();  // else it is another job's by now
    if (known_ && ours) tcsetattr(STDIN_FILENO, TCSANOW, &settings_);
  }

 private:
  termios settings_{};
  bool known_;
};

[[noreturn]] void become(const std::string& path, std::vector<char*>& argv, const sigset_t& mask, Group group,
                         pid_t parent) {
  // posix_spawn could not ask for this.
  prctl(PR_SET_PDEATHSIG, SIGTERM);
  if (getppid() == parent) {
    if (group == Group::own) setpgid(0, 0);
    sigprocmask(SIG_SETMASK, &mask, nullptr);
    execv(path.c_str(), argv.data());
    complain(printable(path) + " cannot be started: " + std::generic_category().message(errno) + "\n");
  }
  _exit(3);
}

pid_t start(const std::string& path, const std::vector<std::string>& arguments, Group group,
            const sigset_t& mask) {
  std::vector<std::string> words = {path};
  words.insert(words.end(), arguments.begin(), arguments.end());
  std::vector<char*> argv;
  argv.reserve(words.size() + 1);
  for (std::string& word : words) argv.push_back(word.data());
  argv.push_back(nullptr);

  std::fflush(stdout);
  const pid_t parent = getpid(), child = fork();
  if (child < 0) throw std::system_error(errno, std::generic_category(), path + " cannot be started");
  if (child == 0) become(path, argv, mask, group, parent);
  // Here too: a signal may come before the child has got there.
  if (group == Group::own) setpgid(child, child);
  return child;
}

}  // namespace

Ended run_program(const std::string& path, const std::vector<std::string>& arguments, Group group) {
  const sigset_t awaited = signals({SIGCHLD, SIGINT, SIGTERM, SIGHUP, SIGQUIT});
  const Blocked blocked(awaited);
  const TerminalAsItIs terminal;
  const pid_t child = start(path, arguments, group, blocked.before());

  Ended ended;
  for (int status = 0;;) {
    siginfo_t info{};
    if (sigwaitinfo(&awaited, &info) < 0) continue;
    if (info.si_signo != SIGCHLD) {
      ended.passed_on = info.si_signo;
      // The terminal has sent its Ctrl-C to the whole group.
      if (group == Group::own)
        kill(-child, info.si_signo);
      else if (info.si_code != SI_KERNEL)
        kill(child, info.si_signo);
    } else if (waitpid(child, &status, WNOHANG) == child) {
      ended.by_signal = WIFSIGNALED(status);
      ended.status = ended.by_signal ? 128 + WTERMSIG(status) : WEXITSTATUS(status);
      terminal.put_back();
      return ended;
    }
  }
}

Beside::Beside(const std::string& path, const std::vector<std::string>& arguments) {
  sigset_t mask;
  sigprocmask(SIG_BLOCK, nullptr, &mask);
  process_ = start(path, arguments, Group::own, mask);
}

Beside::~Beside() {
  kill(-process_, SIGTERM);
  while (waitpid(process_, nullptr, 0) < 0 && errno == EINTR) {
  }
}

void end_by(int signal) {
  std::signal(signal, SIG_DFL);
  raise(signal);
}

}  // namespace byhand::course
