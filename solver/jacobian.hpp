#pragma once

#include <cstring>

#include "solver/model.hpp"

namespace byhand {

namespace detail {

/// Two numbers that the processor adds and multiplies at once.
using Pair [[gnu::vector_size(16)]] = double;

/// Σ aᵢ bᵢ of 2N numbers, even and odd terms apart; each sum is that of its halves.
template <int N>
inline Pair sums_of_products(const double* a, const double* b) {
  if constexpr (N == 1) {
    Pair x, y;
    std::memcpy(&x, a, sizeof x);
    std::memcpy(&y, b, sizeof y);
    return x * y;
  } else {
    constexpr int half = N / 2;
    return sums_of_products<half>(a, b) + sums_of_products<N - half>(a + 2 * half, b + 2 * half);
  }
}

}  // namespace detail

/// One number for each of a constraint's K rows.
template <int K, class T = double>
using Rows = Packed<T, K>;

/// J of (4) for a constraint of K rows between two bodies: K × 2 dof numbers in the order of (6), l1 a1 l2
/// a2.
template <class M, int K>
struct Jacobian {
  Packed<double, K, 2 * M::dof, Eigen::RowMajor> matrix;

  auto l1() const { return matrix.template leftCols<M::linear>(); }
  auto a1() const { return matrix.template middleCols<M::angular>(M::linear); }
  auto l2() const { return matrix.template middleCols<M::linear>(M::dof); }
  auto a2() const { return matrix.template rightCols<M::angular>(); }
  auto side1() const { return matrix.template leftCols<M::dof>(); }
  auto side2() const { return matrix.template rightCols<M::dof>(); }

  /// The dof numbers of row k that belong to one body.
  const double* side1(int k) const { return &matrix(k, 0); }
  const double* side2(int k) const { return &matrix(k, M::dof); }

  /// Sets one row from its four parts, as (14)–(16) list them.
  void set_row(int k, const Linear<M>& l1, const Angular<M>& a1, const Linear<M>& l2, const Angular<M>& a2) {
    auto row = matrix.row(k);
    row.template segment<M::linear>(0) = l1;
    row.template segment<M::angular>(M::linear) = a1;
    row.template segment<M::linear>(M::dof) = l2;
    row.template segment<M::angular>(M::dof + M::linear) = a2;
  }
};

//! [along]
/// The row that (14), (15) and (16) share, along a world direction u: [-u  -r1 × u  u  r2 × u].
template <class M, int K>
[[gnu::always_inline]] inline void set_row_along(Jacobian<M, K>& J, int k, const Linear<M>& u, const Arm<M>& r1,
                                                 const Arm<M>& r2) {
  J.set_row(k, -u, -cross(r1, u), u, cross(r2, u));
}
//! [along]

/// Σ aᵢ bᵢ of N numbers. Written out, as expression templates would take most of the time of compiling the solver.
template <int N>
inline double sum_of_products(const double* a, const double* b) {
  if constexpr (N <= 3) {
    double sum = a[0] * b[0];
    for (int i = 1; i < N; ++i) sum += a[i] * b[i];
    return sum;
  } else {
    static_assert(N % 2 == 0);
    const detail::Pair sums = detail::sums_of_products<N / 2>(a, b);
    return sums[0] + sums[1];
  }
}

//! [8]
/// (8): JV = l1·v1 + a1·ω1 + l2·v2 + a2·ω2, the rate at which the constraint's value changes [units of C per
/// second]. A side of J is its l and a, as V is v and ω.
template <class M, int K>
Rows<K> dot(const Jacobian<M, K>& J, const Velocity<M>& V1, const Velocity<M>& V2) {
  Rows<K> rates;
  for (int k = 0; k < K; ++k)
    rates[k] = sum_of_products<M::dof>(J.side1(k), V1.data()) + sum_of_products<M::dof>(J.side2(k), V2.data());
  return rates;
}
//! [8]

}  // namespace byhand
