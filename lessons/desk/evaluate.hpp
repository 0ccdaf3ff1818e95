#pragma once

#include <cmath>
#include <cstdlib>

#include "lessons/desk/vocabulary.hpp"

namespace byhand::desk {

/// The value of every symbol of a vocabulary, by its id.
template <class T>
using Environment = std::vector<Value<T>>;

template <class T>
Value<T> evaluate(const Node& e, const Environment<T>& values) {
  using std::abs, std::atan2, std::cos, std::sin, std::sqrt;
  const auto a = [&] { return evaluate(*e.of[0], values); };
  const auto b = [&] { return evaluate(*e.of[1], values); };
  switch (e.op) {
    case Op::number: {
      Value<T> result(e.shape);
      const T value =
          e.divisor > 1 ? T(static_cast<double>(e.numerator)) / T(static_cast<double>(e.divisor)) : T(e.number);
      if (e.shape.scalar())
        result[0] = value;
      else if (e.number != 0)
        for (int i = 0; i < e.shape.rows; ++i) result(i, i) = value;
      return result;
    }
    case Op::symbol: return values[static_cast<std::size_t>(e.symbol->id)];
    case Op::negate: return each(a(), [](const T& x) { return T(-x); });
    case Op::add: return each(a(), b(), [](const T& x, const T& y) { return T(x + y); });
    case Op::subtract: return each(a(), b(), [](const T& x, const T& y) { return T(x - y); });
    case Op::multiply: return product(a(), b());
    case Op::divide: {
      const T by = b()[0];
      return each(a(), [&](const T& x) { return T(x / by); });
    }
    case Op::dot: return inner(a(), b());
    case Op::cross: return cross(a(), b());
    case Op::length: {
      const Value<T> of = a();
      if (of.shape.scalar()) return T(abs(of[0]));
      return T(sqrt(inner(of, of)));
    }
    case Op::power: {
      const bool square = e.of[0]->op == Op::length && std::fmod(e.number, 2) == 0;  // |a|² = a·a
      const Value<T> of = square ? evaluate(*e.of[0]->of[0], values) : a();
      const Value<T> base = square ? Value<T>(inner(of, of)) : of;
      const int n = static_cast<int>(e.number) / (square ? 2 : 1);
      T all(1);
      for (int i = 0; i < std::abs(n); ++i) all = all * base[0];
      return n < 0 ? T(T(1) / all) : all;
    }
    case Op::root: return T(sqrt(a()[0]));
    case Op::sine: return T(sin(a()[0]));
    case Op::cosine: return T(cos(a()[0]));
    case Op::arctangent: return T(atan2(a()[0], b()[0]));
    case Op::transpose: return transposed(a());
    case Op::perp: return perp(a());
    case Op::skew: return skew(a());
    case Op::rate: return b();
  }
  return {};
}

/// Gives the symbols that are defined by an expression their values, in the order of their definitions.
template <class T>
void define(const Vocabulary& words, Environment<T>& values) {
  for (const Symbol& symbol : words.all())
    if (symbol.is == Symbol::Is::defined)
      values[static_cast<std::size_t>(symbol.id)] = evaluate(*symbol.definition, values);
}

}  // namespace byhand::desk
