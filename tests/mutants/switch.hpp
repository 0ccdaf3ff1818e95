#pragma once

#include <algorithm>
#include <cstdio>
#include <cstdlib>
#include <cstring>
#include <initializer_list>
#include <type_traits>
#include <utility>

// All mutants of a source in one program: tests/mutants/run writes `a + Operator<'+', 17>() + b` for `a + b`, and
// the environment variable BYHAND_MUTANT=17 turns that plus into a minus while the program runs. The first plus
// makes a Left<'+', 17> of a, the second takes b: the two have the precedence and the order of the one that was
// there, so that nobody needs to know where a and b begin and end. BYHAND_MUTANT=record writes to the file
// BYHAND_REACHED which mutants a run comes by.
namespace byhand::mutants {

inline constexpr int most = 1 << 16;
inline int active = -1;
inline bool recording = false;
inline unsigned char reached[most];

struct Switch {
  Switch() {
    const char* mutant = std::getenv("BYHAND_MUTANT");
    if (!mutant) return;
    recording = std::strcmp(mutant, "record") == 0;
    if (!recording) active = std::atoi(mutant);
  }
  ~Switch() {
    const char* name = std::getenv("BYHAND_REACHED");
    if (!recording || !name) return;
    std::FILE* file = std::fopen(name, "w");
    for (int id = 0; file && id < most; ++id)
      if (reached[id]) std::fprintf(file, "%d\n", id);
    if (file) std::fclose(file);
  }
};
inline const Switch the_switch;

inline bool on_at_run_time(int id) {
  if (__builtin_expect(recording, 0)) reached[id] = 1;
  return __builtin_expect(active == id, 0);
}
/// A constant expression is never mutated.
constexpr bool on(int id) { return !std::is_constant_evaluated() && on_at_run_time(id); }

/// Expressions of Eigen are evaluated, for a sum and a difference are of different types.
template <class T>
constexpr decltype(auto) plain(T&& value) {
  if constexpr (requires { value.eval(); })
    return typename std::remove_cvref_t<T>::PlainObject(value.eval());
  else
    return std::remove_cvref_t<T>(std::forward<T>(value));
}

/// `mutated` if it is on and of the type of `original`; both are lambdas, so that only one is evaluated.
template <int id, class Original, class Mutated>
constexpr auto choose(const Original& original, const Mutated& mutated) {
  using Result = decltype(plain(original()));
  if constexpr (requires { mutated(); }) {
    if constexpr (std::is_same_v<Result, decltype(plain(mutated()))>)
      if (on(id)) return plain(mutated());
  }
  return plain(original());
}

template <char symbol, int id>
struct Operator {};
template <char symbol, int id, class L>
struct Left {
  L&& value;
};

// clang-format off
#define BYHAND_BINARY(SYMBOL, ORIGINAL, MUTATED)                                                                     \
  template <int id, class L>                                                                                         \
  constexpr Left<SYMBOL, id, L> operator ORIGINAL(L&& left, Operator<SYMBOL, id>) {                                  \
    return {std::forward<L>(left)};                                                                                  \
  }                                                                                                                  \
  template <int id, class L, class R>                                                                                \
  constexpr auto operator ORIGINAL(Left<SYMBOL, id, L> left, R&& right) {                                            \
    auto&& a = left.value;                                                                                           \
    const auto original = [](auto&& l, auto&& r) -> decltype(l ORIGINAL r) { return l ORIGINAL r; };                 \
    const auto mutated = [](auto&& l, auto&& r) -> decltype(l MUTATED r) { return l MUTATED r; };                    \
    using Result = decltype(plain(original(a, right)));                                                              \
    if constexpr (requires { mutated(a, right); }) {                                                                 \
      if constexpr (std::is_same_v<Result, decltype(plain(mutated(a, right)))>) {                                    \
        if (on(id)) return plain(mutated(a, right));                                                                 \
      }                                                                                                              \
    }                                                                                                                \
    return plain(original(a, right));                                                                                \
  }
BYHAND_BINARY('+', +, -)
BYHAND_BINARY('-', -, +)
BYHAND_BINARY('*', *, /)
BYHAND_BINARY('/', /, *)
BYHAND_BINARY('<', <, <=)
BYHAND_BINARY('>', >, >=)
BYHAND_BINARY('l', <=, <)
BYHAND_BINARY('g', >=, >)
BYHAND_BINARY('=', ==, !=)
BYHAND_BINARY('!', !=, ==)
#undef BYHAND_BINARY

/// `a += Operator<'p', 17>() += b`: this time the right one is first.
template <char symbol, int id, class R>
struct Right {
  R&& value;
};
#define BYHAND_ASSIGNMENT(SYMBOL, ORIGINAL, MUTATED)                                                                 \
  template <int id, class R>                                                                                         \
  constexpr Right<SYMBOL, id, R> operator ORIGINAL(Operator<SYMBOL, id>, R&& right) {                                \
    return {std::forward<R>(right)};                                                                                 \
  }                                                                                                                  \
  template <int id, class L, class R>                                                                                \
  constexpr decltype(auto) operator ORIGINAL(L&& left, Right<SYMBOL, id, R> right) {                                 \
    if constexpr (requires { left MUTATED std::forward<R>(right.value); }) {                                         \
      if (on(id)) return left MUTATED std::forward<R>(right.value);                                                  \
    }                                                                                                                \
    return left ORIGINAL std::forward<R>(right.value);                                                               \
  }
BYHAND_ASSIGNMENT('p', +=, -=)
BYHAND_ASSIGNMENT('m', -=, +=)
BYHAND_ASSIGNMENT('t', *=, /=)
BYHAND_ASSIGNMENT('d', /=, *=)
#undef BYHAND_ASSIGNMENT
// clang-format on

/// -b.
template <int id, class R>
constexpr auto operator*(Operator<'n', id>, R&& right) {
  return choose<id>([&] { return plain(-right); }, [&] { return plain(right); });
}
/// The right-hand side of && or ||, negated.
template <int id, class R>
constexpr bool operator^(Operator<'^', id>, R&& right) {
  return static_cast<bool>(right) != on(id);
}
template <int id, class T>
constexpr bool condition(T&& value) {
  return static_cast<bool>(value) != on(id);
}

template <int id, class T>
constexpr T constant(T value) {
  if (!on(id)) return value;
  if constexpr (std::is_same_v<T, bool>)
    return !value;
  else if constexpr (std::is_floating_point_v<T>)
    return value == 0 ? 1 : 1.25 * value;
  else
    return value + 1;
}

template <int id, class T>
constexpr T min(const T& a, const T& b) {
  return on(id) ? std::max(a, b) : std::min(a, b);
}
template <int id, class T>
constexpr T min(std::initializer_list<T> all) {
  return on(id) ? std::max(all) : std::min(all);
}
template <int id, class T>
constexpr T max(const T& a, const T& b) {
  return on(id) ? std::min(a, b) : std::max(a, b);
}
template <int id, class T>
constexpr T max(std::initializer_list<T> all) {
  return on(id) ? std::min(all) : std::max(all);
}

}  // namespace byhand::mutants

#define BYHAND_OPERATOR(symbol, id) \
  ::byhand::mutants::Operator<symbol, id> {}
/// Before a statement: leaves it out. A loop, for an if would take the else that follows.
#define BYHAND_STATEMENT(id) \
  for (bool byhand_keeps = !::byhand::mutants::on(id); byhand_keeps; byhand_keeps = false)
