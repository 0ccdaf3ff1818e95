#pragma once

#include <array>

#include "lessons/desk/scalar.hpp"

namespace byhand::desk {

/// 1 × 1: a scalar; n × 1: a vector; else a matrix. At most 3 × 3.
struct Shape {
  int rows = 1, cols = 1;
  bool scalar() const { return rows == 1 && cols == 1; }
  bool vector() const { return rows > 1 && cols == 1; }
  int size() const { return rows * cols; }
  friend bool operator==(const Shape&, const Shape&) = default;
};

/// The numbers of a scalar, vector or matrix, row by row.
template <class T>
struct Value {
  Shape shape;
  std::array<T, 9> at{};

  Value() = default;
  explicit Value(Shape s) : shape(s) {}
  Value(const T& scalar) { at[0] = scalar; }

  T& operator()(int row, int col = 0) { return at[static_cast<std::size_t>(row * shape.cols + col)]; }
  const T& operator()(int row, int col = 0) const { return at[static_cast<std::size_t>(row * shape.cols + col)]; }
  T& operator[](int i) { return at[static_cast<std::size_t>(i)]; }
  const T& operator[](int i) const { return at[static_cast<std::size_t>(i)]; }
};

/// op(a, b) number by number.
template <class T, class Op>
Value<T> each(const Value<T>& a, const Value<T>& b, Op&& op) {
  Value<T> result(a.shape);
  for (int i = 0; i < a.shape.size(); ++i) result[i] = op(a[i], b[i]);
  return result;
}
template <class T, class Op>
Value<T> each(const Value<T>& a, Op&& op) {
  return each(a, a, [&](const T& x, const T&) { return op(x); });
}

template <class T>
T inner(const Value<T>& a, const Value<T>& b) {
  T sum = a[0] * b[0];
  for (int i = 1; i < a.shape.size(); ++i) sum = sum + a[i] * b[i];
  return sum;
}

/// A matrix times a matrix or vector; a scalar times anything, in either order.
template <class T>
Value<T> product(const Value<T>& a, const Value<T>& b) {
  if (a.shape.scalar()) return each(b, [&](const T& x) { return T(a[0] * x); });
  if (b.shape.scalar()) return each(a, [&](const T& x) { return T(x * b[0]); });
  Value<T> result(Shape{a.shape.rows, b.shape.cols});
  for (int i = 0; i < a.shape.rows; ++i)
    for (int j = 0; j < b.shape.cols; ++j) {
      T sum = a(i, 0) * b(0, j);
      for (int k = 1; k < a.shape.cols; ++k) sum = sum + a(i, k) * b(k, j);
      result(i, j) = sum;
    }
  return result;
}

template <class T>
Value<T> transposed(const Value<T>& a) {
  Value<T> result(Shape{a.shape.cols, a.shape.rows});
  for (int i = 0; i < a.shape.rows; ++i)
    for (int j = 0; j < a.shape.cols; ++j) result(j, i) = a(i, j);
  return result;
}

/// A quarter turn in the plane, of a vector or of a matrix's columns: perp(a)·b = a × b.
template <class T>
Value<T> perp(const Value<T>& a) {
  Value<T> result(a.shape);
  for (int j = 0; j < a.shape.cols; ++j) {
    result(0, j) = -a(1, j);
    result(1, j) = a(0, j);
  }
  return result;
}

/// a × b. In the plane that of two vectors is a scalar, and ω × r = ω perp(r).
template <class T>
Value<T> cross(const Value<T>& a, const Value<T>& b) {
  if (a.shape.scalar()) return product(a, perp(b));
  if (b.shape.scalar()) return each(product(perp(a), b), [](const T& x) { return -x; });
  if (a.shape.rows == 2) return a[0] * b[1] - a[1] * b[0];
  Value<T> result(a.shape);
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    result[i] = a[j] * b[k] - a[k] * b[j];
  }
  return result;
}

/// The matrix S with S b = a × b.
template <class T>
Value<T> skew(const Value<T>& a) {
  Value<T> result(Shape{3, 3});
  for (int i = 0; i < 3; ++i) {
    const int j = (i + 1) % 3, k = (i + 2) % 3;
    result(j, k) = -a[i];
    result(k, j) = a[i];
  }
  return result;
}

}  // namespace byhand::desk
