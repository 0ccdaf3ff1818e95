#include "tests/solver/dense.hpp"

#include <gtest/gtest.h>

#include <algorithm>
#include <cmath>
#include <utility>

namespace byhand {

Dense Dense::transposed() const {
  Dense result(columns(), rows());
  for (int i = 0; i < rows(); ++i)
    for (int j = 0; j < columns(); ++j) result(j, i) = (*this)(i, j);
  return result;
}

Dense Dense::inverse() const {
  const int n = rows();
  EXPECT_EQ(columns(), n);
  Dense left = *this, right(n, n);
  for (int i = 0; i < n; ++i) right(i, i) = 1;
  for (int k = 0; k < n; ++k) {
    int pivot = k;
    for (int i = k + 1; i < n; ++i)
      if (std::abs(left(i, k)) > std::abs(left(pivot, k))) pivot = i;
    const double scale = 1 / left(pivot, k);
    for (Dense* half : {&left, &right})
      for (int j = 0; j < n; ++j) {
        std::swap((*half)(k, j), (*half)(pivot, j));
        (*half)(k, j) *= scale;
      }
    for (int i = 0; i < n; ++i) {
      if (i == k) continue;
      const double factor = left(i, k);
      for (Dense* half : {&left, &right})
        for (int j = 0; j < n; ++j) (*half)(i, j) -= factor * (*half)(k, j);
    }
  }
  return right;
}

double Dense::norm() const {
  double sum = 0;
  for (const double x : numbers_) sum += x * x;
  return std::sqrt(sum);
}

double Dense::largest() const {
  double result = 0;
  for (const double x : numbers_) {
    if (std::isnan(x)) return x;
    result = std::max(result, std::abs(x));
  }
  return result;
}

Dense Dense::block(int row, int column, int rows, int columns) const {
  Dense result(rows, columns);
  for (int i = 0; i < rows; ++i)
    for (int j = 0; j < columns; ++j) result(i, j) = (*this)(row + i, column + j);
  return result;
}

void Dense::set_block(int row, int column, const Dense& block) {
  for (int i = 0; i < block.rows(); ++i)
    for (int j = 0; j < block.columns(); ++j) (*this)(row + i, column + j) = block(i, j);
}

Dense operator+(Dense a, const Dense& b) {
  EXPECT_EQ(a.columns(), b.columns());
  EXPECT_EQ(a.rows(), b.rows());
  for (std::size_t i = 0; i < a.numbers_.size(); ++i) a.numbers_[i] += b.numbers_[i];
  return a;
}

Dense operator-(Dense a, const Dense& b) { return a + -1 * b; }

Dense operator*(const Dense& a, const Dense& b) {
  EXPECT_EQ(a.columns(), b.rows());
  Dense result(a.rows(), b.columns());
  for (int i = 0; i < a.rows(); ++i)
    for (int j = 0; j < b.columns(); ++j)
      for (int k = 0; k < a.columns(); ++k) result(i, j) += a(i, k) * b(k, j);
  return result;
}

Dense operator*(double factor, Dense a) {
  for (double& x : a.numbers_) x *= factor;
  return a;
}

double dot(const Dense& a, const Dense& b) {
  EXPECT_EQ(a.rows(), b.rows());
  double sum = 0;
  for (int i = 0; i < a.rows(); ++i) sum += a(i, 0) * b(i, 0);
  return sum;
}

double difference(const Dense& a, const Dense& b) { return (a - b).largest(); }

}  // namespace byhand
