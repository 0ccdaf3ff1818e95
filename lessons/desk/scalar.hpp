#pragma once

#include <cmath>
#include <cstdint>
#include <limits>
#include <stdexcept>

// The scalars over which the desk evaluates an expression: doubles with a bound of their rounding errors, the
// integers modulo a prime, and dual numbers over either.
namespace byhand::desk {

/// a + b·ε with ε² = 0: a quantity and its rate.
template <class T>
struct Dual {
  T at{}, rate{};

  Dual() = default;
  Dual(double constant) : at(constant) {}
  explicit Dual(const T& value, const T& change = T{}) : at(value), rate(change) {}

  friend Dual operator-(const Dual& a) { return Dual(-a.at, -a.rate); }
  friend Dual operator+(const Dual& a, const Dual& b) { return Dual(a.at + b.at, a.rate + b.rate); }
  friend Dual operator-(const Dual& a, const Dual& b) { return Dual(a.at - b.at, a.rate - b.rate); }
  friend Dual operator*(const Dual& a, const Dual& b) { return Dual(a.at * b.at, a.rate * b.at + a.at * b.rate); }
  friend Dual operator/(const Dual& a, const Dual& b) {
    const T q = a.at / b.at;
    return Dual(q, (a.rate - q * b.rate) / b.at);
  }
  friend Dual sqrt(const Dual& a) {
    const T r = sqrt(a.at);
    return Dual(r, a.rate / (T(2) * r));
  }
  friend Dual sin(const Dual& a) { return Dual(sin(a.at), cos(a.at) * a.rate); }
  friend Dual cos(const Dual& a) { return Dual(cos(a.at), -(sin(a.at) * a.rate)); }
  friend Dual atan2(const Dual& y, const Dual& x) {
    return Dual(atan2(y.at, x.at), (x.at * y.rate - y.at * x.rate) / (x.at * x.at + y.at * y.at));
  }
  friend Dual abs(const Dual& a) { return value_of(a.at) < 0 ? -a : a; }
};

/// A double and a bound of its rounding error in units of 2⁻⁵³, which grows where terms cancel.
struct Tracked {
  double at = 0, error = 0;

  Tracked() = default;
  Tracked(double value) : at(value), error(std::fabs(value)) {}
  Tracked(double value, double bound) : at(value), error(bound + std::fabs(value)) {}

  friend Tracked operator-(const Tracked& a) { return {-a.at, a.error}; }
  friend Tracked operator+(const Tracked& a, const Tracked& b) { return {a.at + b.at, a.error + b.error}; }
  friend Tracked operator-(const Tracked& a, const Tracked& b) { return {a.at - b.at, a.error + b.error}; }
  friend Tracked operator*(const Tracked& a, const Tracked& b) {
    return {a.at * b.at, std::fabs(a.at) * b.error + std::fabs(b.at) * a.error};
  }
  friend Tracked operator/(const Tracked& a, const Tracked& b) {
    const double q = a.at / b.at;
    return {q, (a.error + std::fabs(q) * b.error) / std::fabs(b.at)};
  }
  friend Tracked sqrt(const Tracked& a) {
    const double r = std::sqrt(a.at);
    return {r, a.error / (2 * r)};
  }
  friend Tracked sin(const Tracked& a) { return {std::sin(a.at), a.error}; }
  friend Tracked cos(const Tracked& a) { return {std::cos(a.at), a.error}; }
  friend Tracked atan2(const Tracked& y, const Tracked& x) {
    return {std::atan2(y.at, x.at), (y.error + x.error) / std::hypot(x.at, y.at)};
  }
  friend Tracked abs(const Tracked& a) { return {std::fabs(a.at), a.error}; }
};

inline double value_of(double a) { return a; }
inline double value_of(const Tracked& a) { return a.at; }
template <class T>
double value_of(const Dual<T>& a) {
  return value_of(a.at);
}

/// A number of the field of integers modulo the prime 2⁶¹ − 1, in which rational expressions are evaluated
/// exactly: two different ones of degree n agree at a random place with probability n/2⁶¹ (Schwartz and Zippel,
/// 1979/80).
class Modular {
 public:
  static constexpr std::uint64_t prime = (std::uint64_t{1} << 61) - 1;

  Modular() = default;
  /// Of an integer; fractions are built by division.
  Modular(double integer) : of_(residue(static_cast<std::int64_t>(integer))) {}
  static Modular of(std::int64_t integer) {
    Modular m;
    m.of_ = residue(integer);
    return m;
  }

  friend Modular operator-(Modular a) { return raw(a.of_ == 0 ? 0 : prime - a.of_); }
  friend Modular operator+(Modular a, Modular b) { return raw((a.of_ + b.of_) % prime); }
  friend Modular operator-(Modular a, Modular b) { return a + -b; }
  friend Modular operator*(Modular a, Modular b) {
    const Wide product = static_cast<Wide>(a.of_) * b.of_;  // 2⁶¹ is 1 modulo the prime
    const std::uint64_t folded =
        static_cast<std::uint64_t>(product & prime) + static_cast<std::uint64_t>(product >> 61);
    return raw(folded >= prime ? folded - prime : folded);
  }
  /// b⁻¹ = b^(prime - 2), of Fermat.
  friend Modular operator/(Modular a, Modular b) {
    for (std::uint64_t e = prime - 2; e > 0; e >>= 1, b = b * b)
      if (e & 1) a = a * b;
    return a;
  }
  friend bool operator==(Modular, Modular) = default;

  friend Modular sqrt(Modular) { irrational(); }
  friend Modular sin(Modular) { irrational(); }
  friend Modular cos(Modular) { irrational(); }
  friend Modular atan2(Modular, Modular) { irrational(); }
  friend Modular abs(Modular) { irrational(); }
  friend double value_of(Modular) { irrational(); }

 private:
  __extension__ using Wide = unsigned __int128;

  [[noreturn]] static void irrational() { throw std::logic_error("an irrational function modulo a prime"); }
  static Modular raw(std::uint64_t number) {
    Modular m;
    m.of_ = number;
    return m;
  }
  static std::uint64_t residue(std::int64_t integer) {
    const std::int64_t p = static_cast<std::int64_t>(prime), rest = integer % p;
    return static_cast<std::uint64_t>(rest < 0 ? rest + p : rest);
  }

  std::uint64_t of_ = 0;
};

}  // namespace byhand::desk
