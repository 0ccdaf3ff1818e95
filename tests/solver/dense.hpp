#pragma once

#include <Eigen/Core>
#include <vector>

// Reference arithmetic of the tests: matrices of any size, computed by plain loops that are compiled once and not
// for each model and size.
namespace byhand {

class Dense {
 public:
  /// Zeros.
  Dense(int rows, int columns) : columns_(columns), numbers_(rows * columns) {}
  /// The numbers of any matrix or expression of Eigen's.
  template <class A>
  Dense(const Eigen::MatrixBase<A>& matrix)
      : Dense(static_cast<int>(matrix.rows()), static_cast<int>(matrix.cols())) {
    const auto& evaluated = matrix.eval();
    for (int i = 0; i < rows(); ++i)
      for (int j = 0; j < columns(); ++j) (*this)(i, j) = evaluated.coeff(i, j);
  }

  int rows() const { return columns_ == 0 ? 0 : static_cast<int>(numbers_.size()) / columns_; }
  int columns() const { return columns_; }
  double& operator()(int i, int j) { return numbers_[i * columns_ + j]; }
  double operator()(int i, int j) const { return numbers_[i * columns_ + j]; }

  Dense transposed() const;
  /// By Gauss and Jordan, with the largest pivot of each column.
  Dense inverse() const;
  /// The root of the sum of the squares.
  double norm() const;
  /// The largest absolute value, NaN if any is.
  double largest() const;
  Dense row(int i) const { return block(i, 0, 1, columns()); }
  Dense column(int j) const { return block(0, j, rows(), 1); }
  Dense block(int row, int column, int rows, int columns) const;
  void set_block(int row, int column, const Dense& block);

  friend Dense operator+(Dense a, const Dense& b);
  friend Dense operator-(Dense a, const Dense& b);
  friend Dense operator*(const Dense& a, const Dense& b);
  friend Dense operator*(double factor, Dense a);

 private:
  int columns_;
  std::vector<double> numbers_;
};

/// The sum of the products of two columns' numbers.
double dot(const Dense& a, const Dense& b);

/// The largest difference between two matrices of any size, zero sizes too.
double difference(const Dense& a, const Dense& b);

}  // namespace byhand
