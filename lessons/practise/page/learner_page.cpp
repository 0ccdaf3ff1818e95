// Around a learner's functions in a page: compiled once for each exercise, linked with the learner's file in the
// page. Its arguments and answers are numbers in this module's memory.

#include <cstddef>
#include <cstdlib>
#include <new>

#include BYHAND_SIGNATURE
#define BYHAND_UNDEFINED_HANDLERS
#include "lessons/practise/judge/undefined.hpp"
#include "lessons/practise/judge/wire.hpp"

#define EXPORT(name) extern "C" __attribute__((export_name(#name)))
#define PAGE(name) extern "C" [[noreturn]] __attribute__((import_module("page"), import_name(#name)))

PAGE(not_written) void page_not_written();
PAGE(undefined) void page_undefined(unsigned kind, unsigned line);
PAGE(endless) void page_endless();
PAGE(no_memory) void page_no_memory();

namespace {
byhand::practise::Numbers in, out;
}

EXPORT(arguments) double* arguments(int count) {
  in.resize(static_cast<std::size_t>(count));
  return in.data();
}
EXPORT(call) int call(int which) {
  out = byhand::practise::answer(static_cast<std::size_t>(which), in, FUNCTIONS);
  return static_cast<int>(out.size());
}
EXPORT(answers) const double* answers() { return out.data(); }

void plain::not_written_yet() { page_not_written(); }
void byhand_undefined(unsigned kind, unsigned line) { page_undefined(kind, line); }

/// Clang calls it at each branch of the learner's code. Nothing else can end a loop and know its line.
extern "C" void __sanitizer_cov_trace_pc() {
  static unsigned left = 100'000'000;
  if (--left == 0) page_endless();
}

void* operator new(std::size_t size) {
  if (void* memory = std::malloc(size > 0 ? size : 1)) return memory;
  page_no_memory();
}
void* operator new[](std::size_t size) { return ::operator new(size); }

/// The learner's own would be a second one.
int main() { return 0; }
