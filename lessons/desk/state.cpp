#include "lessons/desk/state.hpp"

#include <array>

namespace byhand::desk {
namespace {

using Is = Symbol::Is;

/// The rotation of a half angle's tangent or of a quaternion of any length, over any field.
template <class F>
Value<F> rotation(int dimension, const std::array<F, 4>& q) {
  Value<F> R(Shape{dimension, dimension});
  if (dimension == 2) {
    const F norm = q[0] * q[0] + q[1] * q[1];
    const F c = (q[0] * q[0] - q[1] * q[1]) / norm, s = F(2) * q[0] * q[1] / norm;
    R(0, 0) = R(1, 1) = c;
    R(0, 1) = -s;
    R(1, 0) = s;
    return R;
  }
  const F w = q[0], norm = w * w + q[1] * q[1] + q[2] * q[2] + q[3] * q[3];
  for (int i = 0; i < 3; ++i)
    for (int j = 0; j < 3; ++j) {
      const auto a = static_cast<std::size_t>(i + 1), b = static_cast<std::size_t>(j + 1);
      F x = F(2) * q[a] * q[b];
      if (i == j)
        x = x + F(2) * w * w - norm;
      else if ((j - i + 3) % 3 == 1)
        x = x - F(2) * w * q[static_cast<std::size_t>(6 - i - j - 2)];
      else
        x = x + F(2) * w * q[static_cast<std::size_t>(6 - i - j - 2)];
      R(i, j) = x / norm;
    }
  return R;
}

template <class F>
Value<F> column(const Value<F>& R, int j) {
  Value<F> result(Shape{R.shape.rows, 1});
  for (int i = 0; i < R.shape.rows; ++i) result[i] = R(i, j);
  return result;
}

/// A state from a source of rotations and of numbers for a symbol.
template <class F, class Turn, class Number>
State<F> state_of(const Vocabulary& words, Turn&& turn, Number&& number) {
  State<F> state(words.all().size());
  const Value<F> frame = turn(nullptr);
  for (const Symbol& symbol : words.all()) {
    Value<F>& value = state[static_cast<std::size_t>(symbol.id)];
    value = Value<F>(symbol.shape);
    if (symbol.is == Is::orientation) {
      value = turn(&symbol);
    } else if (symbol.axis >= 3) {
      value[symbol.axis - 3] = F(1);
    } else if (symbol.axis >= 0) {
      value = column(frame, symbol.axis);
    } else if (symbol.unit_length && symbol.shape.vector()) {
      value = column(turn(nullptr), 0);
    } else if (symbol.is != Is::defined) {
      for (int i = 0; i < symbol.shape.size(); ++i) value[i] = number(symbol);
    }
  }
  return state;
}

/// Angles in the plane and the rotations that belong to them.
void turn_by_angles(const Vocabulary& words, State<double>& state) {
  for (const Symbol& symbol : words.all()) {
    if (symbol.is != Is::orientation || words.world().dimension != 2) continue;
    const double angle = state[static_cast<std::size_t>(words.at("θ" + std::to_string(symbol.body + 1)).id)][0];
    Value<double>& R = state[static_cast<std::size_t>(symbol.id)];
    R(0, 0) = R(1, 1) = std::cos(angle);
    R(1, 0) = std::sin(angle);
    R(0, 1) = -R(1, 0);
  }
}

bool positive(const Symbol& symbol) {
  return symbol.is == Is::fixed && symbol.shape.scalar() && symbol.unit.known && symbol.unit.m == 1 &&
         symbol.unit.s == 0;
}

}  // namespace

std::uint64_t Random::bits() {
  std::uint64_t z = state_ += 0x9E3779B97F4A7C15u;
  z = (z ^ (z >> 30)) * 0xBF58476D1CE4E5B9u;
  z = (z ^ (z >> 27)) * 0x94D049BB133111EBu;
  return z ^ (z >> 31);
}

double Random::between(double low, double high) {
  return low + (high - low) * static_cast<double>(bits() >> 11) * 0x1p-53;
}

State<double> random_state(const Vocabulary& words, Random& random) {
  const int n = words.world().dimension;
  const auto turn = [&](const Symbol*) {
    return rotation<double>(
        n, {random.between(0.2, 1), random.between(-1, 1), random.between(-1, 1), random.between(-1, 1)});
  };
  State<double> state = state_of<double>(words, turn, [&](const Symbol& symbol) {
    if (symbol.is == Is::angle) return random.between(-3.5, 3.5);
    if (symbol.is == Is::turning) return random.between(-1, 1);
    return positive(symbol) ? random.between(0.3, 2) : random.between(-2, 2);
  });
  turn_by_angles(words, state);
  return state;
}

State<Modular> random_state_modulo(const Vocabulary& words, Random& random) {
  const int n = words.world().dimension;
  const auto any = [&] { return Modular::of(static_cast<std::int64_t>(random.bits() >> 3)); };
  return state_of<Modular>(
      words,
      [&](const Symbol*) {
        return rotation<Modular>(n, {any(), any(), any(), any()});
      },
      [&](const Symbol&) { return any(); });
}

State<double> simple_state(const Vocabulary& words, Random& random) {
  const int n = words.world().dimension;
  static constexpr std::array<std::array<double, 4>, 6> space = {
      {{1, 0, 0, 0}, {1, 0, 0, 1}, {1, 1, 0, 0}, {1, 1, 1, 1}, {2, 0, 0, 1}, {2, 1, 0, 0}}};
  static constexpr std::array<std::array<double, 4>, 6> plane = {
      {{1, 0, 0, 0}, {1, 1, 0, 0}, {2, 1, 0, 0}, {3, 1, 0, 0}, {1, -1, 0, 0}, {2, -1, 0, 0}}};
  const auto turn = [&](const Symbol*) {
    return rotation<double>(n, (n == 2 ? plane : space)[static_cast<std::size_t>(random.below(6))]);
  };
  State<double> state = state_of<double>(words, turn, [&](const Symbol& symbol) {
    const int small = 1 + random.below(3);
    if (positive(symbol)) return static_cast<double>(small);
    return random.below(2) ? static_cast<double>(small) : -static_cast<double>(small);
  });
  if (n == 2)
    for (const Symbol& symbol : words.all())
      if (symbol.is == Is::orientation) {
        const Value<double>& R = state[static_cast<std::size_t>(symbol.id)];
        state[static_cast<std::size_t>(words.at("θ" + std::to_string(symbol.body + 1)).id)][0] =
            std::atan2(R(1, 0), R(0, 0));
      }
  return state;
}

void turn(const Vocabulary& words, State<double>& state, int body, int axis, double angle) {
  const std::string number = std::to_string(body);
  if (words.world().dimension == 2) {
    state[static_cast<std::size_t>(words.at("θ" + number).id)][0] += angle;
    turn_by_angles(words, state);
    return;
  }
  Value<double>& R = state[static_cast<std::size_t>(words.at("R" + number).id)];
  const int i = (axis + 1) % 3, j = (axis + 2) % 3;
  const double c = std::cos(angle), s = std::sin(angle);
  for (int column = 0; column < 3; ++column) {
    const double a = R(i, column), b = R(j, column);
    R(i, column) = c * a - s * b;
    R(j, column) = s * a + c * b;
  }
}

}  // namespace byhand::desk
