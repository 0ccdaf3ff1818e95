#pragma once

// Counts the allocations of a program that allocations.cpp is part of.
namespace byhand {

inline long allocations = 0;

template <class F>
long allocations_in(F&& f) {
  const long before = allocations;
  f();
  return allocations - before;
}

}  // namespace byhand
