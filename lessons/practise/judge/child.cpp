// The process around a learner's functions: reads calls from the judge's channel and answers there. It knows no
// right answer. Compiled once for each exercise, with its signature.hpp.

#include <signal.h>
#include <sys/resource.h>
#include <unistd.h>

#include <cstdio>

#include BYHAND_SIGNATURE
#include "lessons/practise/judge/protocol.hpp"
#include "lessons/practise/judge/wire.hpp"
#define BYHAND_UNDEFINED_HANDLERS
#include "lessons/practise/judge/undefined.hpp"

namespace {

using namespace byhand::practise;

bool receive(void* bytes, std::size_t count) {
  for (auto* at = static_cast<char*>(bytes); count > 0;) {
    const ssize_t got = read(channel, at, count);
    if (got <= 0) return false;
    at += got;
    count -= static_cast<std::size_t>(got);
  }
  return true;
}

template <std::size_t N>
void reply(const double (&numbers)[N]) {
  [[maybe_unused]] const auto written = write(channel, numbers, sizeof numbers);
}

constexpr std::size_t handler_stack = 16384;
alignas(16) char stack_of_handler[handler_stack];
const char* top_of_stack = nullptr;

/// A fault just below what the stack may use is recursion without an end.
void fault(int number, siginfo_t* info, void*) {
  constexpr std::ptrdiff_t most = 8 << 20, around = 1 << 20;
  const std::ptrdiff_t below = top_of_stack - static_cast<const char*>(info->si_addr);
  if (below > most - around && below < most + around) {
    reply({too_deep});
    _exit(0);
  }
  signal(number, SIG_DFL);
}

void watch_the_stack() {
  char here = 0;
  top_of_stack = &here;
  const stack_t own{stack_of_handler, 0, handler_stack};
  sigaltstack(&own, nullptr);
  struct sigaction action {};
  action.sa_sigaction = fault;
  action.sa_flags = SA_SIGINFO | SA_ONSTACK;
  sigaction(SIGSEGV, &action, nullptr);
}

}  // namespace

void byhand_undefined(unsigned kind, unsigned line) {
  reply({undefined, static_cast<double>(kind), static_cast<double>(line)});
  _exit(0);
}

void plain::not_written_yet() {
  reply({not_written});
  _exit(0);
}

int main() {
  std::setvbuf(stdout, nullptr, _IOLBF, 0);  // nothing printed is lost with a crash
  watch_the_stack();
  reply({ready});
  Call call{};
  while (receive(&call, sizeof call)) {
    Numbers arguments(static_cast<std::size_t>(call.count));
    if (!receive(arguments.data(), arguments.size() * sizeof(double))) break;
    Numbers answered = answer(static_cast<std::size_t>(call.function), arguments, FUNCTIONS);
    answered.insert(answered.begin(), static_cast<double>(answered.size()));
    [[maybe_unused]] const auto written = write(channel, answered.data(), answered.size() * sizeof(double));
  }
}

// Drawn in by the judge's linker, so that a learner's own main is a second one.
extern "C" void byhand_child() {}
