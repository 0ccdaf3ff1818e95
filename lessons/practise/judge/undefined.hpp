#pragma once

// What the compiler calls where a learner's code does what C++ leaves undefined (-fsanitize=…). Whoever includes
// this defines byhand_undefined(); the line is 0 in a header of the system.
extern "C" [[noreturn]] void byhand_undefined(unsigned kind, unsigned line);

namespace byhand::practise {

/// "Your code … in line 5."
inline constexpr const char* undefined_words[] = {
    "divides a whole number by zero",
    "uses an index beyond the end of an array",
    "computes a whole number beyond what an int can hold",
    "uses a pointer that points nowhere",
    "converts a number that is too large to a whole number",
    "reaches a place that it promised never to reach",
};

}  // namespace byhand::practise

#ifdef BYHAND_UNDEFINED_HANDLERS
#include <cstring>
struct UndefinedPlace {
  const char* file;
  unsigned line, column;
};
#define UNDEFINED(name, kind, ...)                                                              \
  extern "C" [[noreturn]] void __ubsan_handle_##name(const UndefinedPlace* at, ##__VA_ARGS__) { \
    byhand_undefined(kind, std::strncmp(at->file, "/usr/", 5) == 0 ? 0 : at->line);             \
  }
UNDEFINED(divrem_overflow_abort, 0, void*, void*)
UNDEFINED(out_of_bounds_abort, 1, void*)
UNDEFINED(add_overflow_abort, 2, void*, void*)
UNDEFINED(sub_overflow_abort, 2, void*, void*)
UNDEFINED(mul_overflow_abort, 2, void*, void*)
UNDEFINED(negate_overflow_abort, 2, void*)
UNDEFINED(type_mismatch_v1_abort, 3, void*)
UNDEFINED(float_cast_overflow_abort, 4, void*)
UNDEFINED(builtin_unreachable, 5)
#undef UNDEFINED
#endif
