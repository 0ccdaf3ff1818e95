#pragma once

#include <cstdlib>
#include <new>

// Counts the allocations of the program that includes this, in its one source file.
namespace byhand {
inline long allocations = 0;

inline void* counted(std::size_t size) {
  ++allocations;
  if (void* memory = std::malloc(size)) return memory;
  throw std::bad_alloc();
}

template <class F>
long allocations_in(F&& f) {
  const long before = allocations;
  f();
  return allocations - before;
}
}  // namespace byhand

// Every allocation of this program passes through here, also those that may fail in silence.
void* operator new(std::size_t size) { return byhand::counted(size); }
void* operator new[](std::size_t size) { return byhand::counted(size); }
void* operator new(std::size_t size, const std::nothrow_t&) noexcept {
  ++byhand::allocations;
  return std::malloc(size);
}
[[gnu::noinline]] void operator delete(void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete[](void* memory, std::size_t) noexcept { std::free(memory); }
[[gnu::noinline]] void operator delete(void* memory, const std::nothrow_t&) noexcept { std::free(memory); }
