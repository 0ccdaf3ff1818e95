#pragma once

#include <cstdint>

#include "lessons/desk/evaluate.hpp"

// States of two bodies at which lines are judged: where they are, how they are turned, how they move, and every
// constant.
namespace byhand::desk {

/// Numbers that look random and are the same in every run and on every machine (splitmix64).
class Random {
 public:
  explicit Random(std::uint64_t seed) : state_(seed) {}
  std::uint64_t bits();
  double between(double low, double high);
  int below(int count) { return static_cast<int>(bits() % static_cast<std::uint64_t>(count)); }

 private:
  std::uint64_t state_;
};

/// Values by symbol; of vectors fixed to a body, in the frame of that body.
template <class F>
using State = std::vector<Value<F>>;

State<double> random_state(const Vocabulary& words, Random& random);
State<Modular> random_state_modulo(const Vocabulary& words, Random& random);
/// One of small whole numbers and Pythagorean turns, to be shown.
State<double> simple_state(const Vocabulary& words, Random& random);

/// Turns a body, 1 or 2, about an axis of the world, 0 to 2 (in the plane the only one), by an angle.
void turn(const Vocabulary& words, State<double>& state, int body, int axis, double angle);

/// v and ω of both bodies as one degree of freedom after the other, all zero but number `moving`.
template <class F>
void move_along(const Vocabulary& words, State<F>& state, int moving) {
  int at = 0;
  for (const char* body : {"1", "2"})
    for (const char* name : {"v", "ω"}) {
      const Symbol* symbol = words.find(std::string(name) + body);
      if (!symbol) continue;
      for (int i = 0; i < symbol->shape.size(); ++i)
        state[static_cast<std::size_t>(symbol->id)][i] = F(at++ == moving ? 1.0 : 0.0);
    }
}

namespace detail {

template <class T, class F>
Value<T> lifted(const Value<F>& value) {
  Value<T> result(value.shape);
  for (int i = 0; i < value.shape.size(); ++i) result[i] = T(value[i]);
  return result;
}

}  // namespace detail

/// The symbols' values at a state.
template <class T, class F>
Environment<T> environment(const Vocabulary& words, const State<F>& state) {
  Environment<T> values(state.size());
  for (const Symbol& symbol : words.all()) {
    const auto id = static_cast<std::size_t>(symbol.id);
    values[id] = detail::lifted<T>(state[id]);
    if (symbol.is == Symbol::Is::turning)
      values[id] = product(values[static_cast<std::size_t>(words.at("R" + std::to_string(symbol.body + 1)).id)],
                           values[id]);
  }
  define(words, values);
  return values;
}

/// The symbols' values and rates along the motion of both bodies at a state: ẋ = v, θ̇ = ω, Ṙ = ω × R.
template <class T, class F>
Environment<Dual<T>> moving_environment(const Vocabulary& words, const State<F>& state) {
  Environment<Dual<T>> values(state.size());
  const auto of = [&](const std::string& name) {
    return detail::lifted<T>(state[static_cast<std::size_t>(words.at(name).id)]);
  };
  for (const Symbol& symbol : words.all()) {
    const auto id = static_cast<std::size_t>(symbol.id);
    const std::string body = std::to_string(symbol.body + 1);
    Value<Dual<T>>& value = values[id];
    value = Value<Dual<T>>(symbol.shape);
    const Value<T> at = detail::lifted<T>(state[id]);
    for (int i = 0; i < symbol.shape.size(); ++i) value[i] = Dual<T>(at[i]);
    const auto moves = [&](const Value<T>& rate) {
      for (int i = 0; i < symbol.shape.size(); ++i) value[i].rate = rate[i];
    };
    if (symbol.is == Symbol::Is::centre) moves(of("v" + body));
    if (symbol.is == Symbol::Is::angle) moves(of("ω" + body));
    if (symbol.is == Symbol::Is::orientation) {
      const Value<T> spin = of("ω" + body);
      for (int column = 0; column < symbol.shape.cols; ++column) {
        Value<T> axis(Shape{symbol.shape.rows, 1});
        for (int row = 0; row < symbol.shape.rows; ++row) axis[row] = at(row, column);
        const Value<T> rate = cross(spin, axis);
        for (int row = 0; row < symbol.shape.rows; ++row) value(row, column).rate = rate[row];
      }
    }
    if (symbol.is == Symbol::Is::turning)
      value = product(values[static_cast<std::size_t>(words.at("R" + body).id)], value);
  }
  define(words, values);
  return values;
}

}  // namespace byhand::desk
