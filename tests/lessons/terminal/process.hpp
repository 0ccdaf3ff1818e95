#pragma once

#include <fcntl.h>
#include <sys/wait.h>
#include <unistd.h>

#include <csignal>
#include <cstdio>
#include <cstdlib>
#include <filesystem>
#include <fstream>
#include <iterator>
#include <memory>
#include <string>
#include <vector>

namespace byhand::tests {

struct Finished {
  int status;
  std::string said, complained;  // standard output and standard error
};

inline std::string contents(const std::filesystem::path& path) {
  std::ifstream file(path, std::ios::binary);
  return {std::istreambuf_iterator<char>(file), {}};
}

/// A folder of its own for one test, gone afterwards.
class Folder {
 public:
  Folder() {
    std::string name = (std::filesystem::temp_directory_path() / "byhand-XXXXXX").string();
    if (!mkdtemp(name.data())) std::abort();
    path_ = name;
  }
  Folder(const Folder&) = delete;
  Folder& operator=(const Folder&) = delete;
  ~Folder() { std::filesystem::remove_all(path_); }
  const std::filesystem::path& path() const { return path_; }
  std::filesystem::path operator/(const std::string& name) const { return path_ / name; }

 private:
  std::filesystem::path path_;
};

/// Runs a command of the shell without a terminal and without input.
inline Finished run(const std::string& command) {
  const Folder folder;
  const std::string both =
      "(" + command + ") </dev/null >" + (folder / "out").string() + " 2>" + (folder / "err").string();
  const int status = std::system(both.c_str());
  return {WIFEXITED(status) ? WEXITSTATUS(status) : -1, contents(folder / "out"), contents(folder / "err")};
}

/// How often an attack tries: once as it stands, more often where BYHAND_ATTACK says so (./tests/run --attack).
inline int attempts(int standard) {
  const char* const factor = std::getenv("BYHAND_ATTACK");
  return standard * (factor ? std::atoi(factor) : 1);
}

/// The seed of an attack: the same every day, another where BYHAND_SEED says so (./tests/run --attack --seed=N).
inline unsigned seeded(unsigned standard) {
  const char* const other = std::getenv("BYHAND_SEED");
  return standard + (other ? static_cast<unsigned>(std::strtoul(other, nullptr, 10)) : 0);
}

/// A program started without a shell, its output in files.
class Started {
 public:
  explicit Started(std::vector<std::string> command, const std::vector<std::string>& environment = {}) {
    const std::string out = (folder_ / "out").string(), err = (folder_ / "err").string();
    std::vector<char*> argv;
    for (std::string& word : command) argv.push_back(word.data());
    argv.push_back(nullptr);
    process_ = fork();
    if (process_ != 0) return;
    // Whoever runs the tests in the background may ignore Ctrl-C.
    for (const int number : {SIGINT, SIGQUIT, SIGHUP, SIGTERM}) std::signal(number, SIG_DFL);
    const auto redirect = [](const char* file, int flags, int to) { dup2(open(file, flags, 0600), to); };
    redirect("/dev/null", O_RDONLY, 0);
    redirect(out.c_str(), O_WRONLY | O_CREAT, 1);
    redirect(err.c_str(), O_WRONLY | O_CREAT, 2);
    for (const std::string& variable : environment)
      setenv(variable.substr(0, variable.find('=')).c_str(), variable.substr(variable.find('=') + 1).c_str(), 1);
    execv(argv[0], argv.data());
    _exit(127);
  }
  Started(const Started&) = delete;
  Started& operator=(const Started&) = delete;
  ~Started() {
    if (process_ <= 0) return;
    kill(process_, SIGKILL);
    waitpid(process_, nullptr, 0);
  }

  pid_t process() const { return process_; }
  void send(int signal) const { kill(process_, signal); }
  bool runs() const {
    siginfo_t info{};
    waitid(P_PID, static_cast<id_t>(process_), &info, WEXITED | WNOHANG | WNOWAIT);
    return info.si_pid != process_;
  }

  /// Waits for its end. The status of a program that a signal ended is minus the number of the signal.
  Finished finish() {
    int status = 0;
    waitpid(process_, &status, 0);
    process_ = -1;
    return {WIFEXITED(status) ? WEXITSTATUS(status) : -WTERMSIG(status), contents(folder_ / "out"),
            contents(folder_ / "err")};
  }

 private:
  Folder folder_;
  pid_t process_ = -1;
};

}  // namespace byhand::tests
