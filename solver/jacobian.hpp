#pragma once

#include "solver/model.hpp"

namespace byhand {

namespace detail {

/// The sum of every second of 2N numbers.
template <int N>
inline double pairwise_sum(const double* terms) {
  if constexpr (N == 1)
    return terms[0];
  else
    return pairwise_sum<N / 2>(terms) + pairwise_sum<N - N / 2>(terms + 2 * (N / 2));
}

}  // namespace detail

/// One number for each of a constraint's K rows.
template <int K, class T = double>
using Rows = Eigen::Matrix<T, K, 1>;

/// J of (4) for a constraint of K rows between two bodies: K × 2 dof numbers in the order of (6), l1 a1 l2
/// a2.
template <class M, int K>
struct Jacobian {
  Eigen::Matrix<double, K, 2 * M::dof, Eigen::RowMajor> matrix;

  auto l1() const { return matrix.template leftCols<M::linear>(); }
  auto a1() const { return matrix.template middleCols<M::angular>(M::linear); }
  auto l2() const { return matrix.template middleCols<M::linear>(M::dof); }
  auto a2() const { return matrix.template rightCols<M::angular>(); }
  auto side1() const { return matrix.template leftCols<M::dof>(); }
  auto side2() const { return matrix.template rightCols<M::dof>(); }

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
void set_row_along(Jacobian<M, K>& J, int k, const Linear<M>& u, const Arm<M>& r1, const Arm<M>& r2) {
  J.set_row(k, -u, -cross(r1, u), u, cross(r2, u));
}
//! [along]

/// Σ aᵢ bᵢ of N numbers. Even and odd terms are summed side by side, each sum halved and halved again, as the
/// processor adds pairs. Plain loops, for expression templates would take most of the time of compiling the
/// solver.
template <int N>
inline double sum_of_products(const double* a, const double* b) {
  double terms[N];
  for (int i = 0; i < N; ++i) terms[i] = a[i] * b[i];
  if constexpr (N == 1) return terms[0];
  const double even_and_odd = detail::pairwise_sum<N / 2>(terms) + detail::pairwise_sum<N / 2>(terms + 1);
  return N % 2 ? even_and_odd + terms[N - 1] : even_and_odd;
}

//! [8]
/// (8): JV = l1·v1 + a1·ω1 + l2·v2 + a2·ω2, the rate at which the constraint's value changes [units of C per
/// second]. A side of J is its l and a, as V is v and ω.
template <class M, int K>
Rows<K> dot(const Jacobian<M, K>& J, const Velocity<M>& V1, const Velocity<M>& V2) {
  constexpr int dof = M::dof;
  const double* row = J.matrix.data();
  Rows<K> rates;
  for (int k = 0; k < K; ++k, row += 2 * dof)
    rates[k] = sum_of_products<dof>(row, V1.data()) + sum_of_products<dof>(row + dof, V2.data());
  return rates;
}
//! [8]

}  // namespace byhand
