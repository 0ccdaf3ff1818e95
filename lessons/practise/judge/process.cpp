#include "lessons/practise/judge/process.hpp"

#include <fcntl.h>
#include <fmt/format.h>
#include <poll.h>
#include <sys/mman.h>
#include <sys/socket.h>
#include <sys/wait.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <chrono>
#include <cmath>
#include <csignal>
#include <cstdlib>
#include <cstring>

#include "lessons/practise/judge/confine.hpp"
#include "lessons/practise/judge/protocol.hpp"
#include "renderer/error.hpp"

namespace byhand::practise {
namespace {

using Clock = std::chrono::steady_clock;
using renderer::EnvironmentError;

constexpr std::size_t most_printed = 64u << 10;
constexpr double most_numbers = 1e6;
constexpr int patience = 60'000;  // [ms] for one answer; a loop meets its limit of computing long before

std::string whole(int file) {
  std::string text(static_cast<std::size_t>(std::max<off_t>(0, lseek(file, 0, SEEK_END))), '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, text.data(), text.size(), 0))));
  return text;
}

/// Starts a program whose standard input is `in` and whose output goes to `out`, after it has done `prepare`.
template <class Prepare>
pid_t start(const std::vector<std::string>& command, int in, int out, const Prepare& prepare) {
  std::vector<char*> argv;
  for (const std::string& word : command) argv.push_back(const_cast<char*>(word.c_str()));
  argv.push_back(nullptr);
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw EnvironmentError("no process could be started for " + command.front());
  if (child > 0) return child;
  setsid();
  dup2(in, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  dup2(in, replies);
  close_range(replies + 1, ~0u, 0);
  prepare();
  execv(argv[0], argv.data());
  _exit(127);
}

/// The ends of files that a fork must not lose to low numbers.
int high(int file) {
  const int moved = fcntl(file, F_DUPFD_CLOEXEC, 10);
  close(file);
  return moved;
}

void kill_all(pid_t child) {
  kill(-child, SIGKILL);
  kill(child, SIGKILL);
}

}  // namespace

Process::Process(const std::filesystem::path& program, Limits limits) : limits_(limits) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw EnvironmentError("no socket could be opened");
  socket_ = high(ends[0]);
  const int inner = high(ends[1]);
  print_ = high(memfd_create("printed", MFD_CLOEXEC));
  child_ = start({program.string()}, inner, print_, [&] {
    limit(limits, most_printed);
    allow_computing_only();
  });
  close(inner);
}

Process::~Process() {
  if (child_ > 0) {
    kill_all(child_);
    waitpid(child_, nullptr, 0);
  }
  close(socket_);
  close(print_);
}

Numbers Process::call(std::size_t which, const Numbers& arguments) {
  if (child_ < 0) throw Stopped{"Your code has ended."};
  const Call head{static_cast<double>(which), static_cast<double>(arguments.size())};
  std::string bytes(sizeof head + arguments.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  if (!arguments.empty())
    std::memcpy(bytes.data() + sizeof head, arguments.data(), arguments.size() * sizeof(double));
  if (send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size())) ended();

  double count = 0;
  receive(&count, sizeof count);
  if (count == not_written) throw Stopped{"Not written yet.", true};
  if (!(count >= 0 && count <= most_numbers && count == std::floor(count)))
    end("Your code wrote on the judge's channel; only what your functions return counts.");
  Numbers answered(static_cast<std::size_t>(count));
  receive(answered.data(), answered.size() * sizeof(double));
  return answered;
}

std::string Process::printed() const { return whole(print_); }

void Process::receive(void* bytes, std::size_t count) {
  for (auto* at = static_cast<char*>(bytes); count > 0;) {
    pollfd readable{socket_, POLLIN, 0};
    if (poll(&readable, 1, patience) <= 0) end("Your code waits for something that never comes.");
    const ssize_t got = recv(socket_, at, count, 0);
    if (got <= 0) ended();
    at += got;
    count -= static_cast<std::size_t>(got);
  }
}

void Process::ended() {
  int status = 0;
  waitpid(child_, &status, 0);
  child_ = -1;
  if (WIFEXITED(status))
    throw Stopped{fmt::format("Your code ended the program with status {} instead of returning a value.",
                              WEXITSTATUS(status))};
  switch (WTERMSIG(status)) {
    case SIGSYS:
      throw Stopped{"Your code asked the system for a file, a process or the network; an exercise needs none."};
    case SIGXFSZ: throw Stopped{fmt::format("Your code printed more than {} KB.", most_printed >> 10)};
    case SIGKILL:
    case SIGXCPU:
      throw Stopped{fmt::format(
          "Your code did not return within {} s of computing; look for a loop that never ends.", limits_.seconds)};
    default: throw Stopped{fmt::format("Your code crashed: {}.", strsignal(WTERMSIG(status)))};
  }
}

void Process::end(const std::string& sentence) {
  kill_all(child_);
  waitpid(child_, nullptr, 0);
  child_ = -1;
  throw Stopped{sentence};
}

Finished run_confined(const std::vector<std::string>& command, const std::vector<std::filesystem::path>& readable,
                      const std::filesystem::path& folder, Limits limits) {
  const int said = high(memfd_create("said", MFD_CLOEXEC));
  const int nothing = high(open("/dev/null", O_RDONLY | O_CLOEXEC));
  const pid_t child = start(command, nothing, said, [&] {
    limit(limits, limits.bytes);
    setenv("TMPDIR", folder.c_str(), 1);
    setenv("LC_ALL", "C", 1);
    allow_files(readable, folder);
  });
  const auto deadline = Clock::now() + std::chrono::duration<double>(4 * limits.seconds);
  int status = 0;
  pid_t done = 0;
  while ((done = waitpid(child, &status, WNOHANG)) == 0 && Clock::now() < deadline) usleep(2000);
  if (done == 0) {
    kill_all(child);
    waitpid(child, &status, 0);
  }
  const Finished finished{done > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1, whole(said)};
  close(said);
  close(nothing);
  return finished;
}

Scratch::Scratch() {
  std::string name = (std::filesystem::temp_directory_path() / "practise-XXXXXX").string();
  if (!mkdtemp(name.data())) throw EnvironmentError("no folder could be made in " + name);
  path_ = name;
}

Scratch::~Scratch() {
  std::error_code ignored;
  std::filesystem::remove_all(path_, ignored);
}

}  // namespace byhand::practise
