#pragma once

#include <algorithm>
#include <cstddef>
#include <cstring>
#include <functional>
#include <span>
#include <tuple>
#include <type_traits>
#include <utility>
#include <vector>

// How the arguments and results of a learner's function travel between the judge and the process that runs it: as
// numbers, so that any function of structs of doubles can be called from outside.
namespace byhand::practise {

using Numbers = std::vector<double>;

/// Calls function `which` of an exercise with these arguments; returns its result followed by all that it could
/// change: references and spans.
using Code = std::function<Numbers(std::size_t which, const Numbers& arguments)>;

template <class T>
constexpr std::size_t size_of_numbers() {
  static_assert(std::is_trivially_copyable_v<T> && sizeof(T) % sizeof(double) == 0, "a struct of doubles");
  return sizeof(T) / sizeof(double);  // NOLINT(bugprone-sizeof-expression): T may be double itself.
}

template <class T>
void put(Numbers& numbers, const T& value) {
  const std::size_t end = numbers.size();
  numbers.resize(end + size_of_numbers<T>());
  std::memcpy(&numbers[end], &value, sizeof value);
}

class Reader {
 public:
  explicit Reader(const Numbers& numbers) : rest_(numbers) {}
  bool ended() const { return rest_.empty(); }

  /// Zeros beyond the end.
  template <class T>
  T take() {
    T value{};
    const std::size_t count = size_of_numbers<T>();
    if (rest_.size() >= count) std::memcpy(static_cast<void*>(&value), rest_.data(), sizeof value);
    rest_ = rest_.subspan(std::min(count, rest_.size()));
    return value;
  }

 private:
  std::span<const double> rest_;
};

/// An argument of type A where the function runs.
template <class A>
struct Argument {
  using T = std::remove_cvref_t<A>;
  T held;
  explicit Argument(Reader& in) : held(in.take<T>()) {}
  A pass() { return held; }
  static constexpr bool changes = std::is_lvalue_reference_v<A> && !std::is_const_v<std::remove_reference_t<A>>;
  void put_changed(Numbers& out) const {
    if constexpr (changes) put(out, held);
  }
  static void put_given(Numbers& in, const T& value) { put(in, value); }
  static void take_changed(Reader& out, A value) {
    if constexpr (changes) value = out.take<T>();
  }
};

template <class T>
struct Argument<std::span<T>> {
  std::vector<T> held;
  explicit Argument(Reader& in) : held(static_cast<std::size_t>(in.take<double>())) {
    for (T& value : held) value = in.take<T>();
  }
  std::span<T> pass() { return held; }
  void put_changed(Numbers& out) const {
    for (const T& value : held) put(out, value);
  }
  static void put_given(Numbers& in, std::span<T> values) {
    put(in, static_cast<double>(values.size()));
    for (const T& value : values) put(in, value);
  }
  static void take_changed(Reader& out, std::span<T> values) {
    for (T& value : values) value = out.take<T>();
  }
};

template <class R, class... A>
Numbers answer(const Numbers& in, R (*function)(A...)) {
  Reader reader(in);
  std::tuple<Argument<A>...> arguments{Argument<A>(reader)...};
  Numbers out;
  std::apply(
      [&](auto&... argument) {
        if constexpr (std::is_void_v<R>)
          function(argument.pass()...);
        else
          put(out, function(argument.pass()...));
        (argument.put_changed(out), ...);
      },
      arguments);
  return out;
}

/// Function `which` of these.
template <class... F>
Numbers answer(std::size_t which, const Numbers& in, F... functions) {
  Numbers out;
  std::size_t i = 0;
  ((i++ == which ? void(out = answer(in, functions)) : void()), ...);
  return out;
}

/// A learner's function as the judge calls it.
template <class F>
class Function;

template <class R, class... A>
class Function<R (*)(A...)> {
 public:
  Function(const Code& code, std::size_t which) : code_(&code), which_(which) {}

  R operator()(A... arguments) const {
    Numbers in;
    (Argument<A>::put_given(in, arguments), ...);
    const Numbers out = (*code_)(which_, in);
    Reader reader(out);
    if constexpr (std::is_void_v<R>) {
      (Argument<A>::take_changed(reader, arguments), ...);
    } else {
      const R result = reader.take<R>();
      (Argument<A>::take_changed(reader, arguments), ...);
      return result;
    }
  }

 private:
  const Code* code_;
  std::size_t which_;
};

template <class Pointers>
struct Functions;

template <class... F>
struct Functions<std::tuple<F...>> {
  static auto of(const Code& code) {
    return [&]<std::size_t... I>(std::index_sequence<I...>) { return std::tuple(Function<F>(code, I)...); }
    (std::index_sequence_for<F...>());
  }
};

}  // namespace byhand::practise
