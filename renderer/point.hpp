#pragma once

#include <array>
#include <cmath>
#include <concepts>
#include <cstddef>

namespace byhand::renderer {

/// Accessors of a vector with N components. A type that knows its size when it is compiled, as Eigen's do, must
/// have the size N.
template <class V, int N>
concept VectorLike = requires(const V& v) {
  { v.x() } -> std::convertible_to<double>;
  { v.y() } -> std::convertible_to<double>;
}
&&(N == 2 ||
   requires(const V& v) {
     { v.z() } -> std::convertible_to<double>;
   }) &&
    (!requires { V::SizeAtCompileTime; } || V::SizeAtCompileTime == N);

/// A vector with N components, 2 or 3. The renderer's headers use it in place of Eigen's vectors, which take
/// seconds to compile. It converts from them and to them, and its functions have their names.
template <int N>
class Vector {
 public:
  static constexpr int SizeAtCompileTime = N;

  constexpr Vector() = default;
  template <std::convertible_to<double>... T>
  requires(sizeof...(T) == N) constexpr Vector(const T&... components)
      : components_{static_cast<double>(components)...} {}
  template <VectorLike<N> V>
  constexpr Vector(const V& v) : components_{v.x(), v.y()} {
    if constexpr (N == 3) components_[2] = v.z();
  }

  /// To an Eigen vector of the same size.
  template <class V>
  requires(V::SizeAtCompileTime == N) constexpr operator V() const {
    V v;
    for (int i = 0; i < N; ++i) v[i] = (*this)[i];
    return v;
  }

  // NOLINTBEGIN(readability-identifier-naming): Eigen's names.
  static constexpr Vector Zero() { return {}; }
  static constexpr Vector Constant(double value) {
    Vector v;
    v.components_.fill(value);
    return v;
  }
  static constexpr Vector Unit(int i) {
    Vector v;
    v[i] = 1;
    return v;
  }
  static constexpr Vector UnitX() { return Unit(0); }
  static constexpr Vector UnitY() { return Unit(1); }
  static constexpr Vector UnitZ() requires(N == 3) { return Unit(2); }

  constexpr int size() const { return N; }
  constexpr double operator[](int i) const { return components_[static_cast<std::size_t>(i)]; }
  constexpr double& operator[](int i) { return components_[static_cast<std::size_t>(i)]; }
  constexpr double x() const { return components_[0]; }
  constexpr double y() const { return components_[1]; }
  constexpr double z() const requires(N == 3) { return components_[2]; }
  constexpr double& x() { return components_[0]; }
  constexpr double& y() { return components_[1]; }
  constexpr double& z() requires(N == 3) { return components_[2]; }

  constexpr Vector& operator+=(const Vector& v) {
    for (int i = 0; i < N; ++i) (*this)[i] += v[i];
    return *this;
  }
  constexpr Vector& operator-=(const Vector& v) {
    for (int i = 0; i < N; ++i) (*this)[i] -= v[i];
    return *this;
  }
  constexpr Vector& operator*=(double s) {
    for (double& c : components_) c *= s;
    return *this;
  }
  constexpr Vector& operator/=(double s) {
    for (double& c : components_) c /= s;
    return *this;
  }
  friend constexpr Vector operator+(Vector a, const Vector& b) { return a += b; }
  friend constexpr Vector operator-(Vector a, const Vector& b) { return a -= b; }
  friend constexpr Vector operator*(Vector a, double s) { return a *= s; }
  friend constexpr Vector operator*(double s, Vector a) { return a *= s; }
  friend constexpr Vector operator/(Vector a, double s) { return a /= s; }
  friend constexpr Vector operator-(Vector a) { return a *= -1; }
  friend constexpr bool operator==(const Vector&, const Vector&) = default;

  constexpr double dot(const Vector& v) const {
    double sum = x() * v.x();
    for (int i = 1; i < N; ++i) sum += (*this)[i] * v[i];
    return sum;
  }
  constexpr double squaredNorm() const { return dot(*this); }
  double norm() const { return std::sqrt(squaredNorm()); }
  /// The unit vector in this direction; zero stays zero.
  Vector normalized() const {
    const double square = squaredNorm();
    return square > 0 ? *this / std::sqrt(square) : *this;
  }
  bool allFinite() const {
    for (const double c : components_)
      if (!std::isfinite(c)) return false;
    return true;
  }
  constexpr Vector cwiseMin(const Vector& v) const {
    return cwise(v, [](double a, double b) { return b < a ? b : a; });
  }
  constexpr Vector cwiseMax(const Vector& v) const {
    return cwise(v, [](double a, double b) { return a < b ? b : a; });
  }
  constexpr Vector cwiseProduct(const Vector& v) const {
    return cwise(v, [](double a, double b) { return a * b; });
  }
  constexpr Vector cross(const Vector& v) const requires(N == 3) {
    return {y() * v.z() - z() * v.y(), z() * v.x() - x() * v.z(), x() * v.y() - y() * v.x()};
  }
  /// A unit vector at right angles to this one, which must not be zero.
  Vector unitOrthogonal() const requires(N == 3) {
    const bool along_z = std::abs(x()) <= 1e-12 * std::abs(z()) && std::abs(y()) <= 1e-12 * std::abs(z());
    const Vector across = along_z ? Vector(0, -z(), y()) : Vector(-y(), x(), 0);
    return across * (1 / across.norm());
  }
  // NOLINTEND(readability-identifier-naming)

 private:
  template <class F>
  constexpr Vector cwise(const Vector& v, F f) const {
    Vector result;
    for (int i = 0; i < N; ++i) result[i] = f((*this)[i], v[i]);
    return result;
  }

  std::array<double, N> components_{};
};

using Point = Vector<2>;   ///< in the plane
using Point3 = Vector<3>;  ///< in space

}  // namespace byhand::renderer
