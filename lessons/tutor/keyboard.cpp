#include "lessons/tutor/keyboard.hpp"

#include <poll.h>
#include <unistd.h>

#include <algorithm>
#include <array>
#include <csignal>

#include "renderer/file.hpp"

namespace byhand::tutor {
namespace {

volatile std::sig_atomic_t interrupted = 0;
constexpr size_t longest = 4096;  // bytes of a line that are kept, as a terminal does

/// The next prompt ends the dialogue. Whatever takes longer than a second to reach it is aborted by the alarm.
extern "C" void on_interrupt(int) {
  interrupted = 1;
  alarm(1);
}

extern "C" void on_alarm(int) {
  constexpr char reset[] = "\033[0m\n";
  [[maybe_unused]] const auto written = write(STDOUT_FILENO, reset, sizeof reset - 1);
  renderer::remove_unfinished();
  _exit(128 + SIGINT);
}

struct sigaction former;

}  // namespace

Keyboard::Keyboard() {
  struct sigaction action {};
  action.sa_handler = on_interrupt;  // without SA_RESTART: the signal interrupts read()
  sigaction(SIGINT, &action, &former);
  std::signal(SIGALRM, on_alarm);
}

Keyboard::~Keyboard() { sigaction(SIGINT, &former, nullptr); }

std::optional<std::string> Keyboard::line() {
  std::string line;
  for (auto end = rest_.find('\n'); end == std::string::npos; end = rest_.find('\n')) {
    line.append(rest_, 0, longest - std::min(longest, line.size()));
    std::array<char, 4096> buffer{};
    const ssize_t count = interrupted ? -1 : read(STDIN_FILENO, buffer.data(), buffer.size());
    if (count <= 0) {
      rest_.clear();
      return std::nullopt;
    }
    rest_.assign(buffer.data(), static_cast<size_t>(count));
  }
  const auto end = rest_.find('\n');
  line.append(rest_, 0, std::min(end, longest - line.size()));
  rest_.erase(0, end + 1);
  return line;
}

bool Keyboard::pressed_within(int milliseconds) {
  if (!rest_.empty()) return true;
  pollfd input{STDIN_FILENO, POLLIN, 0};
  return poll(&input, 1, milliseconds) != 0;  // on Ctrl-C, line() has nothing to wait for
}

}  // namespace byhand::tutor
