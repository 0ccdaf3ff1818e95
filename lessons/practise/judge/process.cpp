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
#include <fstream>
#include <iterator>

#include "lessons/page/error.hpp"
#include "lessons/practise/judge/confine.hpp"
#include "lessons/practise/judge/messages.hpp"
#include "lessons/practise/judge/protocol.hpp"

namespace byhand::practise {
namespace {

using Clock = std::chrono::steady_clock;
using course::EnvironmentError;

constexpr std::size_t most_printed = 64u << 10;
constexpr double most_numbers = 1e6;
constexpr double most_clock = 20;  // [s] for all answers on a machine however busy

/// At most the first megabyte: what a compiler says of a learner's file may be any number of warnings.
std::string whole(int file) {
  constexpr off_t most = 1 << 20;
  std::string text(static_cast<std::size_t>(std::clamp<off_t>(lseek(file, 0, SEEK_END), 0, most)), '\0');
  text.resize(static_cast<std::size_t>(std::max<ssize_t>(0, pread(file, text.data(), text.size(), 0))));
  return text;
}

/// The ends of files that a fork must not lose to low numbers.
int high(int file) {
  const int moved = fcntl(file, F_DUPFD_CLOEXEC, 10);
  close(file);
  return moved;
}

std::vector<char*> pointers(const std::vector<std::string>& words) {
  std::vector<char*> all;
  for (const std::string& word : words) all.push_back(const_cast<char*>(word.c_str()));
  all.push_back(nullptr);
  return all;
}

/// Starts a program with an empty standard input and this environment alone, whose output goes to `out`, after it
/// has done `prepare`. It has `socket` as its channel, if there is one.
template <class Prepare>
pid_t start(const std::vector<std::string>& command, const std::vector<std::string>& environment, int socket,
            int out, const Prepare& prepare) {
  const std::vector<char*> argv = pointers(command), envp = pointers(environment);
  const int nothing = high(open("/dev/null", O_RDONLY | O_CLOEXEC));
  std::fflush(nullptr);
  const pid_t child = fork();
  if (child < 0) throw EnvironmentError("no process could be started for " + command.front());
  if (child > 0) {
    close(nothing);
    return child;
  }
  setsid();
  dup2(nothing, STDIN_FILENO);
  dup2(out, STDOUT_FILENO);
  dup2(out, STDERR_FILENO);
  if (socket >= 0) dup2(socket, channel);
  close_range(socket >= 0 ? channel + 1 : channel, ~0u, 0);
  prepare();
  execve(argv[0], argv.data(), envp.data());
  _exit(127);
}

void kill_all(pid_t child) {
  kill(-child, SIGKILL);
  kill(child, SIGKILL);
}

/// Whether a process sleeps; one that computes, or waits for a processor, does not.
bool sleeps(pid_t process) {
  std::ifstream file(fmt::format("/proc/{}/stat", process));
  const std::string text{std::istreambuf_iterator<char>(file), {}};
  const auto name_ends = text.rfind(") ");
  return name_ends != std::string::npos && text.substr(name_ends + 2, 1) == "S";
}

/// Of a program that called abort(): its own doing, or what the C++ library prints before it does so.
std::string aborted(const std::string& printed, std::size_t bytes) {
  const std::string failed = rest_of_line(printed, ": Assertion `");
  if (!failed.empty()) return fmt::format("Your assertion `{}", failed);
  const std::string type = rest_of_line(printed, "terminate called after throwing an instance of ");
  if (type == "'std::bad_alloc'")
    return fmt::format("Your code asked for more than {} MB of memory.", bytes >> 20);
  if (!type.empty()) return fmt::format("Your code threw an exception, {}, and caught it nowhere.", type);
  return "Your code called abort().";
}

}  // namespace

Process::Process(const std::filesystem::path& program, Limits limits) : limits_(limits) {
  std::array<int, 2> ends{};
  if (socketpair(AF_UNIX, SOCK_STREAM | SOCK_CLOEXEC, 0, ends.data()) != 0)
    throw EnvironmentError("no socket could be opened");
  socket_ = high(ends[0]);
  const int inner = high(ends[1]);
  print_ = high(memfd_create("printed", MFD_CLOEXEC));
  child_ = start({program.string()}, {}, inner, print_, [&] {
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
  if (!ready_) {
    if (received() != ready) wrote_on_the_channel();
    ready_ = true;
  }
  const Call head{static_cast<double>(which), static_cast<double>(arguments.size())};
  std::string bytes(sizeof head + arguments.size() * sizeof(double), '\0');
  std::memcpy(bytes.data(), &head, sizeof head);
  if (!arguments.empty())
    std::memcpy(bytes.data() + sizeof head, arguments.data(), arguments.size() * sizeof(double));
  if (send(socket_, bytes.data(), bytes.size(), MSG_NOSIGNAL) != static_cast<ssize_t>(bytes.size())) ended();

  const double count = received();
  if (count == not_written) throw Stopped{"Not written yet.", true};
  if (count == too_deep) end("Your code calls itself without an end: the stack is full.");
  if (count == undefined) {
    const double kind = received(), line = received();
    if (!is_undefined(kind, line)) wrote_on_the_channel();
    end(undefined_sentence(kind, line));
  }
  if (!(count >= 0 && count <= most_numbers && count == std::floor(count))) wrote_on_the_channel();
  Numbers answered(static_cast<std::size_t>(count));
  receive(answered.data(), answered.size() * sizeof(double));
  return answered;
}

std::string Process::printed() const { return whole(print_); }

double Process::received() {
  double number = 0;
  receive(&number, sizeof number);
  return number;
}

void Process::receive(void* bytes, std::size_t count) {
  const auto begun = Clock::now();
  const auto waited = [&] { return waited_ + std::chrono::duration<double>(Clock::now() - begun).count(); };
  for (auto* at = static_cast<char*>(bytes); count > 0;) {
    if (waited() > most_clock) end(fmt::format("Your code did not return within {} s.", most_clock));
    constexpr int moment = 10;  // [ms]
    pollfd readable{socket_, POLLIN, 0};
    if (poll(&readable, 1, moment) <= 0) {
      if (sleeps(child_)) slept_ += 1e-3 * moment;
      if (slept_ > limits_.seconds) end("Your code waits for something that never comes.");
      continue;
    }
    const ssize_t got = recv(socket_, at, count, 0);
    if (got <= 0) ended();
    at += got;
    count -= static_cast<std::size_t>(got);
  }
  waited_ = waited();
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
      throw Stopped{
          "Your code asked the system for a file, a process, the time or the network; an exercise needs none."};
    case SIGXFSZ: throw Stopped{fmt::format("Your code printed more than {} KB.", most_printed >> 10)};
    case SIGABRT: throw Stopped{aborted(printed(), limits_.bytes)};
    case SIGKILL:
    case SIGXCPU:
      if (ready_)
        throw Stopped{
            fmt::format("Your code did not return within {} s of computing; look for a loop that never ends.",
                        limits_.seconds)};
      [[fallthrough]];
    default:
      throw Stopped{
          ready_ ? fmt::format("Your code crashed ({}): it used memory that is not its own. Look at pointers "
                               "and indices.",
                               strsignal(WTERMSIG(status)))
                 : fmt::format("Your program ended before its first call: its global variables crash it, or "
                               "need more than {} MB.",
                               limits_.bytes >> 20)};
  }
}

void Process::wrote_on_the_channel() {
  end("Your code wrote on the judge's channel; only what your functions return counts.");
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
  constexpr std::size_t most_written = 64u << 20;
  const std::vector<std::string> environment = {"PATH=/usr/bin:/bin", "LC_ALL=C", "TMPDIR=" + folder.string()};
  const pid_t child = start(command, environment, -1, said, [&] {
    limit(limits, most_written);
    allow_files(readable, folder);
  });
  const auto deadline = Clock::now() + std::chrono::duration<double>(limits.seconds);
  int status = 0;
  pid_t done = 0;
  while ((done = waitpid(child, &status, WNOHANG)) == 0 && Clock::now() < deadline) usleep(2000);
  if (done == 0) {
    kill_all(child);
    waitpid(child, &status, 0);
  }
  const Finished finished{done > 0 && WIFEXITED(status) ? WEXITSTATUS(status) : -1, whole(said)};
  close(said);
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
